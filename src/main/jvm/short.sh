# Part of the launchers for Linux and macOS.

# Tells whether a command ends before the optimizing compiler's code pays: the check of small files, and a
# picture of one small file whose arguments state a few samples in all. At half a million they take the same
# processor time with it. Then short_options is the name of the options that it gets.
is_short() {
  command=${1:-}
  short_options=short-options
  size=
  samples=
  files=0
  previous=
  for argument; do
    case $previous in
      -o | --output) previous= && continue ;;
      --size) size=$argument ;;
      -s | --samples) samples=$argument ;;
      --explode) case $argument in *..*) return 1 ;; esac ;;
    esac
    case $argument in
      --size=*) size=${argument#*=} ;;
      --samples=*) samples=${argument#*=} ;;
      --turntable* | --animation* | --sheet* | --explode=*..*) return 1 ;;
    esac
    if [ -f "$argument" ]; then
      files=$((files + 1))
      # A minimal system has no wc.
      [ -r "$argument" ] && bytes=$(wc -c <"$argument" 2>/dev/null) && [ "$bytes" -le 8000000 ] || return 1
    fi
    previous=$argument
  done
  case $command in
    check) short_options=check-options ;;
    render) [ "$files" = 1 ] && is_few "${size%x*}" "${size#*x}" "$samples" ;;
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
