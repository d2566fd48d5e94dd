# For the scripts of this folder: pictures side by side, a name below each.

sheet() {  # PICTURE COLUMNS WIDTH HEIGHT CROP (gnuplot's ranges, or nothing) ; then lines FILE|LABEL on standard input
  local picture=$out/$1.png columns=$2 width=$3 height=$4 crop=$5
  local files=() labels=() file label
  while IFS='|' read -r file label; do files+=("$file") labels+=("$label"); done
  local rows=$(((${#files[@]} + columns - 1) / columns))
  {
    printf '%s\n' "set encoding utf8" "set terminal pngcairo size $((columns * (width + 8))),$((rows * (height + 34))) font 'DejaVu Sans,15' background rgb 'white'"
    printf '%s\n' "set output '$picture'" "set multiplot" "unset border; unset tics; unset key; unset colorbox" "${crop:-set autoscale xfix; set autoscale yfix}"
    for at in "${!files[@]}"; do
      local column=$((at % columns)) row=$((at / columns))
      printf 'set lmargin at screen %s; set rmargin at screen %s\n' "($column + 4.0 / ($width + 8)) / $columns" "($column + 1 - 4.0 / ($width + 8)) / $columns"
      printf 'set tmargin at screen 1 - (%s + 4.0 / (%s + 34)) / %s; set bmargin at screen 1 - (%s + 1 - 30.0 / (%s + 34)) / %s\n' "$row" "$height" "$rows" "$row" "$height" "$rows"
      printf "set label 1 '%s' at graph 0.5, character 0.9 center\n" "${labels[at]}" | sed "s/at graph 0.5, character 0.9/at screen ($column + 0.5) \/ $columns, 1 - ($row + 1 - 14.0 \/ ($height + 34)) \/ $rows/"
      printf "plot '%s' binary filetype=png with rgbimage notitle\n" "${files[at]}"
    done
    printf 'unset multiplot\n'
  } | gnuplot
}
