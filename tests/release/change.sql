-- Changes the file of rows.sql: every target does so with files that each of the others has written.
UPDATE discs SET t = 30, x = x + 100, vy = -vy WHERE id % 5 = 1;
DELETE FROM hulls WHERE id % 11 = 0;
INSERT INTO crowd SELECT id + 100000, x, y, -vx, vy, r FROM crowd WHERE id % 10 = 3;
INSERT INTO boxes(boxes) VALUES ('optimize');
