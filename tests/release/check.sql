-- Reads a file that another target has written: answers are those of the target that wrote it.
INSERT INTO discs(discs) VALUES ('integrity-check');
INSERT INTO hulls(hulls) VALUES ('integrity-check');
INSERT INTO crowd(crowd) VALUES ('integrity-check');
INSERT INTO bodies(bodies) VALUES ('integrity-check');
INSERT INTO alerts(alerts) VALUES ('integrity-check');
SELECT * FROM predictive_join(200, 'discs', 0, NULL, 40) ORDER BY t, a, b;
SELECT * FROM predictive_join(120, 'discs', 50, NULL, 40, 'tree') ORDER BY a, b LIMIT 300;
SELECT * FROM predictive_join(120, 'hulls') ORDER BY t, a, b;
SELECT * FROM predictive_join(60, 'crowd', 0) WHERE dt > 0 ORDER BY t, a, b LIMIT 200;
SELECT * FROM predictive_window(200, 'boxes', 1000, 1500, 2000, 2400) ORDER BY id;
SELECT * FROM predictive_nearest(200, 'discs', 20, 3000, 3000, NULL, 40) ORDER BY rank;
SELECT * FROM predictive_join(30, 'bodies') ORDER BY t, a, b;
SELECT * FROM alerts ORDER BY a, b;
SELECT * FROM discs ORDER BY id LIMIT 50;
PRAGMA integrity_check;
