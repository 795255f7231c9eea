# The pictures of peers.sh, from peers_core.csv and growth.csv in the folder given:
#   gnuplot -c peers.gnuplot FOLDER
folder = ARG1
growth = folder . "/growth.csv"
peers = folder . "/peers_core.csv"
set datafile separator ","
set grid back lc rgb "#dddddd"
methods = "foresee|at rest|boost rtree|cgal boxes"
labels = "foresee, exact contact|foresee at rest (h = 0)|Boost R-tree, plain double|CGAL boxes, plain double"
part(text, i) = (s = text, sum [k = 2:i] (s = s[strstrt(s, "|") + 1:], 0), e = strstrt(s, "|"), e ? s[1:e - 1] : s)
colour(i) = word("#d62728 #999999 #1f77b4 #2ca02c", i)

# Growth: a row of the file belongs to a panel by the first letter of its workload, and what stands behind it is x.
rows_of(letter, method) = sprintf("< awk -F, '$2 == \"%s\" && $1 ~ /^%s-/ { sub(/^.-/, \"\"); print }' %s", method, letter, growth)
set style data linespoints
set logscale xy
set format y "10^{%T}"
set terminal svg size 1180, 400 font "sans,11" background "white"
set output folder . "/growth.svg"
set multiplot layout 1, 3 title "Growth: nanoseconds of one thread an object\n "
do for [panel = 1:3] {
  letter = word("S L G", panel)
  set xlabel part("objects (S)|horizon, 100,000 objects in uniform motion (L)|per cent of the objects 100 times larger (G)", panel)
  set format x panel == 1 ? "10^{%T}" : "%g"
  if (panel == 1) { do for [k = 1:4] { set label k part(labels, k) at screen 0.2 * k, 0.9 center tc rgb colour(k) } } else { unset label }
  plot for [m = 1:4] rows_of(letter, part(methods, m)) using 1:7 lc rgb colour(m) pt 7 ps 0.5 notitle
}
unset multiplot
unset output

# Peers: how many times foresee's time.
unset label
set format x "%g"
set format y "%g"
set xlabel ""
set terminal svg size 1000, 420 font "sans,11" background "white"
set output folder . "/peers.svg"
unset logscale x
set ylabel "times foresee's time, same run"
set style data linespoints
set xtics rotate by -25
set key outside right top
methods = "boost rtree|cgal boxes|brute force|steps of 1|steps of 0.1"
set yrange [0.3:*]
# Workloads stand side by side in the order of the file.
ratios_of(method) = sprintf("< awk -F, 'NR > 1 { if (!($1 in place)) place[$1] = ++count; if ($2 == \"%s\") print place[$1] \",\" $1 \",\" $8 }' %s", method, peers)
set xrange [0.5:*]
set offsets 0, 0.5, 0, 0
plot ratios_of("foresee") using 1:3:xtic(2) with lines lc rgb "#d62728" title "foresee, exact contact", \
  for [m = 1:5] ratios_of(part(methods, m)) using 1:3 with points pt 7 ps 0.8 title part(methods, m)
