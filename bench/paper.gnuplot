# The pictures of the paper's experiments, from paper.csv and paper_stages.csv in the folder given:
#   gnuplot -c paper.gnuplot FOLDER
folder = ARG1
times = folder . "/paper.csv"
stages = folder . "/paper_stages.csv"
set datafile separator ","

sweeps = "h v_max n a_max"
spreads = "uniform zipf city"
motions = "linear accelerated"
label_of(i) = i == 1 ? "horizon h" : i == 2 ? "greatest speed" : i == 3 ? "thousand objects" : "greatest acceleration"

# Where a parameter stands, and its value; NaN for rows of another sweep.
x_of(sweep) = strcol(1) ne sweep ? NaN : sweep eq "h" ? $4 : sweep eq "v_max" ? $5 : sweep eq "n" ? $7 / 1000.0 : $6
of(sweep, spread, motion) = strcol(2) eq spread && strcol(3) eq motion ? x_of(sweep) : NaN

set style data linespoints
set grid back lc rgb "#dddddd"
set xtics 1
unset key
colour(i) = word("#1f77b4 #ff7f0e #2ca02c #d62728 #9467bd #8c564b", i)

# Running time: a row for each distribution, a column for each sweep.
methods = "gpcd grid sij-tpr scan"
do for [motion in motions] {
  columns = motion eq "linear" ? 3 : 4
  set terminal svg size 60 + 280 * columns, 780 font "sans,11" background "white"
  set output folder . "/paper_time_" . motion . ".svg"
  set multiplot layout 3, columns title "Milliseconds a join, " . motion . " motion (scan: brute force; dashed: sij-tpr with loading)\n "
  set logscale y
  set format y "10^{%T}"
  set yrange [0.05:2000]
  do for [spread in spreads] {
    do for [s = 1:columns] {
      set title spread offset 0, -0.7
      set xlabel label_of(s) offset 0, 0.7
      if (s == 1 && spread eq "uniform") { do for [k = 1:4] { set label k word(methods, k) at screen 0.16 * k, 0.95 center tc rgb colour(k) } } else { unset label }
      plot for [m = 1:4] times using (of(word(sweeps, s), spread, motion)):(column(8 + m)) lc rgb colour(m) pt 7 ps 0.5, \
        times using (of(word(sweeps, s), spread, motion)):($11 + $13) lc rgb colour(3) dt 2 pt 6 ps 0.5
    }
  }
  unset multiplot
  unset output
}

# Pairs.
unset logscale
set format y "%g"
set yrange [0:*]
set terminal svg size 1180, 360 font "sans,11" background "white"
set output folder . "/paper_pairs.svg"
set multiplot layout 1, 4 title "Pairs that will touch (full: accelerated, dashed: linear motion)\n "
unset title
do for [s = 1:4] {
  set xlabel label_of(s) offset 0, 0.7
  if (s == 1) { do for [k = 1:3] { set label k word(spreads, k) at screen 0.16 * k, 0.88 center tc rgb colour(k) } } else { unset label }
  plot for [d = 1:3] times using (of(word(sweeps, s), word(spreads, d), "accelerated")):8 lc rgb colour(d) pt 7 ps 0.5, \
    for [d = 1:3] times using (s < 4 ? of(word(sweeps, s), word(spreads, d), "linear") : NaN):8 lc rgb colour(d) dt 2 pt 6 ps 0.5
}
unset multiplot
unset output

# Prune power.
set yrange [0:100]
set terminal svg size 1180, 780 font "sans,11" background "white"
set output folder . "/paper_prune.svg"
set multiplot layout 3, 4 title "Prune power in percent of what the stage before has left (accelerated motion)\n "
test(i) = i == 1 ? "candidates" : i == 2 ? "projection overlap" : i == 3 ? "time interval" : i == 4 ? "trajectory intersection" : "exact time"
# Points join to a line only where no rows of other stages lie between them.
rows_of(sweep, spread, test) = sprintf("< grep '^%s,%s,accelerated,.*,%s,' %s", sweep, spread, test, stages)
do for [spread in spreads] {
  do for [s = 1:4] {
    set title spread offset 0, -0.7
    set xlabel label_of(s) offset 0, 0.7
    if (s == 1 && spread eq "uniform") { do for [k = 1:5] { set label k test(k) at screen 0.16 * k, 0.95 center tc rgb colour(k) } } else { unset label }
    plot for [k = 1:5] rows_of(word(sweeps, s), spread, test(k)) using (x_of(word(sweeps, s))):11 lc rgb colour(k) pt 7 ps 0.5
  }
}
unset multiplot
unset output
