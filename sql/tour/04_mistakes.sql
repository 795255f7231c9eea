.load build/release/foresee
.mode box
.bail off

.print "A wrong value is refused, and the statement changes nothing."
.print
CREATE VIRTUAL TABLE ships USING moving_objects(id, x, y, vx, vy, r);
INSERT INTO ships VALUES (1, 0, 0, 6, 0, 30), (2, 1200, 0, -6, 0, -30);
SELECT count(*) AS ships FROM ships;

.print
.print "A radius is a distance from the centre: write 30."
.print
INSERT INTO ships VALUES (1, 0, 0, 6, 0, 30), (2, 1200, 0, -6, 0, 30);
SELECT a, b, t FROM predictive_join(300);

.print
.print "A wrong declaration is refused too, and says what would be right:"
.print
CREATE VIRTUAL TABLE planes USING moving_objects(id, x, y, z, vx, vy);
.print
.print "So is a wrong question:"
.print
SELECT * FROM predictive_join(-1);
