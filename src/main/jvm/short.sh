# Part of the launchers for Linux and macOS.

# Tells whether a command ends before the optimizing compiler's code pays: the check of small files, a picture of
# one small file whose arguments state a few samples in all, and a drawing of lines, which takes none, of one that
# is not very large. At half a million samples they take the same processor time with it. Then short_options is
# the name of the options that it gets.
is_short() {
  command=${1:-}
  short_options=short-options
  size=
  samples=
  look=
  film=
  files=0
  largest=0
  previous=
  for argument; do
    case $previous in
      -o | --output) previous= && continue ;;
      --size) size=$argument ;;
      -s | --samples) samples=$argument ;;
      --look) look=$argument ;;
      --explode) case $argument in *..*) return 1 ;; esac ;;
    esac
    case $argument in
      --size=*) size=${argument#*=} ;;
      --samples=*) samples=${argument#*=} ;;
      --look=*) look=${argument#*=} ;;
      --checkpoint* | --layers*) film=yes ;;
      --turntable* | --animation* | --sheet* | --explode=*..*) return 1 ;;
    esac
    if [ -f "$argument" ]; then
      files=$((files + 1))
      # Most of a glTF file lies beside it. A minimal system has no wc.
      for file in "$argument" "${argument%.gltf}.bin"; do
        [ -f "$file" ] || continue
        [ -r "$file" ] && bytes=$(wc -c <"$file" 2>/dev/null) || return 1
        [ "$bytes" -le "$largest" ] || largest=$bytes
      done
    fi
    previous=$argument
  done
  case $command,$look,$samples$film in
    render,lines,) [ "$files" = 1 ] && [ "$largest" -le 20000000 ] ;;
    check,*) short_options=check-options && [ "$largest" -le 8000000 ] ;;
    render,*) [ "$files" = 1 ] && [ "$largest" -le 8000000 ] && is_few "${size%x*}" "${size#*x}" "$samples" ;;
    *) return 1 ;;
  esac
}

# Tells whether the product of numbers, of at most four digits each, is small.
is_few() {
  product=1
  for number; do
    case $number in
      '' | 0* | *[!0-9]* | ?????*) return 1 ;;
    esac
    product=$((product * number))
  done
  [ "$product" -le 300000 ]
}
