# The pictures of the report on accuracy, from accuracy.csv and stages.csv in the folder given:
#   gnuplot -c pictures.gnuplot FOLDER
folder = ARG1
table = folder . "/accuracy.csv"
stages = folder . "/stages.csv"
set datafile separator ","

methods = "stepping bisection float double double-fma boost-quartic exact-only filtered"
colours = "#999999 #8c564b #ff7f0e #d62728 #9467bd #17becf #2ca02c #1f77b4"
boxes = "random dense reference-times graze-exact graze-near simultaneous-exact simultaneous-near near-parallel huge-offset huge-acceleration denormal overflow instant same-motion zero-extent cancelling-root mixed-scale unix-times"
balls = "random dense reference-times in-out-in tangent-exact tangent-near point-meets-point huge-offset near-parallel mixed-scale overflow unix-times"

# What a panel shows: the column, where it belongs to this family and method and the method was right about something.
of(shape, family, method) = strcol(1) eq (shape . " " . family) && strcol(3) eq method
percent(count, pairs) = count > 0 ? 100.0 * count / pairs : 0.003
# Errors of zero are drawn on the lowest line.
raised(error, floor) = error > floor ? error : floor

panels(shape) = shape eq "box" ? boxes : balls

do for [shape in "box ball"] {
  rows = (words(panels(shape)) + 2) / 3
  do for [kind in "decisions ulps seconds"] {
    set terminal svg size 1080, 60 + 240 * rows font "sans,11" background "white"
    set output folder . "/" . shape . "_" . kind . ".svg"
    set multiplot layout rows, 3 title (kind eq "decisions" ? "Wrong decisions: filled missed, hollow invented (percent of pairs)" : kind eq "ulps" ? "Error of the begin in units in the last place: median, bar to the 99th percentile, dot at the greatest" : "Error of the begin in seconds: median, bar to the 99th percentile, dot at the greatest") . " against nanoseconds a pair. Families of " . (shape eq "box" ? "boxes" : "balls")
    set logscale xy
    set format x "10^{%T}"
    set xrange [20:1e7]
    set grid back lc rgb "#dddddd"
    unset mxtics
    unset mytics
    do for [family in panels(shape)] {
      set title family offset 0, -0.7
      if (family eq word(panels(shape), 1)) { set key top right samplen 1 font ",8" } else { unset key }
      if (kind eq "decisions") {
        set yrange [0.002:150]
        set ytics ("0" 0.003, "0.01" 0.01, "0.1" 0.1, "1" 1, "10" 10, "100" 100)
        plot for [m = 1:words(methods)] table using (of(shape, family, word(methods, m)) ? $9 : NaN):(percent($7, $5)) with points pt 7 ps 0.7 lc rgb word(colours, m) title word(methods, m), \
          for [m = 1:words(methods)] table using (of(shape, family, word(methods, m)) ? $9 : NaN):(percent($8, $5)) with points pt 6 ps 1.1 lc rgb word(colours, m) notitle
      }
      if (kind eq "ulps") {
        set yrange [0.05:1e20]
        set ytics ("0" 0.1, "1" 1, "10^5" 1e5, "10^{10}" 1e10, "10^{15}" 1e15, "10^{20}" 1e20)
        plot for [m = 1:words(methods)] table using (of(shape, family, word(methods, m)) && $6 > $7 ? $9 : NaN):(raised($11, 0.1)):(raised($11, 0.1)):(raised($12, 0.1)) with yerrorbars pt 7 ps 0.5 lc rgb word(colours, m) title word(methods, m), \
          for [m = 1:words(methods)] table using (of(shape, family, word(methods, m)) && $6 > $7 ? $9 : NaN):(raised($13, 0.1)) with points pt 0 ps 1 lc rgb word(colours, m) notitle
      }
      if (kind eq "seconds") {
        set yrange [1e-25:1e9]
        set ytics ("0" 1e-24, "10^{-20}" 1e-20, "10^{-15}" 1e-15, "10^{-10}" 1e-10, "10^{-5}" 1e-5, "1" 1, "10^5" 1e5)
        plot for [m = 1:words(methods)] table using (of(shape, family, word(methods, m)) && $6 > $7 ? $9 : NaN):(raised($14, 1e-24)):(raised($14, 1e-24)):(raised($15, 1e-24)) with yerrorbars pt 7 ps 0.5 lc rgb word(colours, m) title word(methods, m), \
          for [m = 1:words(methods)] table using (of(shape, family, word(methods, m)) && $6 > $7 ? $9 : NaN):(raised($16, 1e-24)) with points pt 0 ps 1 lc rgb word(colours, m) notitle
      }
    }
    unset multiplot
    unset output
  }
}

# Which stage has the last word: about the decision, and about the begin of those that meet.
reset
set datafile separator ","
set terminal svg size 1080, 760 font "sans,11" background "white"
set output folder . "/stages.svg"
set multiplot layout 2, 1
set style data histograms
set style histogram rowstacked
set style fill solid 0.9 border -1
set boxwidth 0.8
set xtics rotate by -40 scale 0 font ",9"
set yrange [0:100]
set ylabel "percent of pairs"
set key outside right
set title "Who decides"
plot stages every ::1 using (100.0 * $3 / $2):xtic(1) lc rgb "#aec7e8" title "chord (double)", \
  '' every ::1 using (100.0 * $4 / $2) lc rgb "#1f77b4" title "certified double", \
  '' every ::1 using (100.0 * $5 / $2) lc rgb "#2ca02c" title "exact"
set ylabel "percent of contacts"
set title "Who rounds the begin"
plot stages every ::1 using ($6 > 0 ? 100.0 * $7 / $6 : 0):xtic(1) lc rgb "#aec7e8" title "at once: now", \
  '' every ::1 using ($6 > 0 ? 100.0 * $8 / $6 : 0) lc rgb "#1f77b4" title "double-double", \
  '' every ::1 using ($6 > 0 ? 100.0 * $9 / $6 : 0) lc rgb "#2ca02c" title "exact"
unset multiplot
