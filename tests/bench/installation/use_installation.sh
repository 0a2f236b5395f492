#!/usr/bin/env bash
# use_installation.sh BUILD SOURCE PREFIX: installs BUILD into PREFIX and uses gsbench from there, in an
# environment of its own: profiles, emulated station, user's files, manual page, completion, CI example.
set -euo pipefail
build=$1 source=$2 prefix=$3

fail() {
  printf 'FAILED: %s\n' "$*" >&2
  exit 1
}
# expect TEXT PATTERN
expect() { grep --quiet --extended-regexp -- "$2" <<<"$1" || fail "no \"$2\" in: $1"; }

rm -rf "$prefix"
cmake --install "$build" --prefix "$prefix/usr" --strip >/dev/null
found=$(printf '%s\n' "$build" "$source"/{bench,drivers,firmware,profiles,reports} |
  grep --recursive --files-with-matches --fixed-strings --file=- "$prefix" || true)
[ -z "$found" ] || fail "paths of the build in $found"

mv "$prefix/usr" "$prefix/opt"  # an installation may be moved
home=$prefix/home
mkdir -p "$home/.local/share/gsbench/profiles/mine" "$home/repository/build"
cd "$home"
gsbench() { env -i HOME="$home" PATH="$prefix/opt/bin:/usr/sbin:/usr/bin:/bin" gsbench "$@"; }

expect "$(gsbench --version)" '^gsbench [0-9.]+'
expect "$(gsbench run paper/loss-500mw)" "^Report: $home/.local/share/gsbench/runs/.*/report.html$"
expect "$(gsbench run paper/loss-500mw --station emulated)" '^PASS'
expect "$(gsbench runs)" '^[0-9TZa-f-]+ +finished +PASS +1 +paper/loss-500mw'

# The user's own profile has a name of its own; one with a shipped name is refused, the others are not.
sed 's/^title = .*/title = "My loss"/' "$prefix/opt/share/gsbench/profiles/paper/loss-500mw.toml" \
  >.local/share/gsbench/profiles/mine/loss.toml
expect "$(gsbench list)" 'mine/loss +My loss'
expect "$(gsbench check mine/loss)" 'mine/loss'
cp .local/share/gsbench/profiles/mine/{loss,'my loss'}.toml
mkdir .local/share/gsbench/profiles/paper
cp .local/share/gsbench/profiles/{mine/loss,paper/loss-500mw}.toml
expect "$(gsbench run regression/command)" '^PASS'
expect "$(gsbench check paper/loss-500mw 2>&1)" 'have the same name'
rm -r .local/share/gsbench/profiles/paper

expect "$(man --local-file "$prefix"/opt/share/man/man1/gsbench.1.gz)" '^ +gsbench run \[OPTIONS\]'

# completed WORD…: as bash completes the last word.
completed() {
  (
    # shellcheck source=/dev/null
    source "$prefix/opt/share/bash-completion/completions/gsbench"
    COMP_WORDS=("$prefix/opt/bin/gsbench" "$@") COMP_CWORD=$#
    export HOME=$home
    _gsbench
    printf '%s\n' "${COMPREPLY[@]}"
  )
}
[ "$(completed run paper/loss-5)" = paper/loss-500mw ] || fail "completion of a profile: $(completed run paper/loss-5)"
[ "$(completed run 'mine/my')" = 'mine/my\ loss' ] || fail "completion of a name with a space"
expect "$(completed check mine/loss paper/)" '^paper/loss-320mw$'
expect "$(completed run paper/loss-500mw --station = emu)" '^emulated$'
expect "$(completed params '')" '^ieee24$'
expect "$(completed report "$(date -u +%Y)")" '^[0-9]{8}T'
expect "$(completed report --format j)" '^junit$'
expect "$(completed reproduce --only table4,fig2)" '^table4,fig21$'
expect "$(completed stu)" '^study$'

# The example of CI, with the installed firmware as that of the repository.
examples=$prefix/opt/share/doc/gsbench/examples/ci
cp -r "$examples" repository/ci
cp "$prefix/opt/share/gsbench/firmware/gs-outlet-mps2_an386.elf" repository/build/outlet.elf
sed 's/^max = 960.0/max = 300.0/' .local/share/gsbench/profiles/mine/loss.toml >repository/fails.toml
check() { (cd repository && env -i HOME="$home" PATH="$prefix/opt/bin:/usr/sbin:/usr/bin:/bin" ci/check-firmware ci/station.toml "$@"); }
check results paper/loss-500mw paper/loss-320mw >/dev/null || fail "check-firmware: exit code $?"
[ "$(find repository/results -name junit.xml | wc -l)" -eq 2 ] || fail "check-firmware: not two JUnit files"
status=0
check results2 fails.toml paper/loss-500mw >/dev/null || status=$?
[ "$status" -eq 1 ] || fail "check-firmware with a limit that is exceeded: exit code $status"
