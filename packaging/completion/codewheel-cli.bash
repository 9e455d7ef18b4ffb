# SPDX-License-Identifier: GPL-3.0-or-later
# Completion of codewheel-cli in bash; the program itself says what a word may be.
_codewheel_cli() {
    local cur words cword line lines
    _get_comp_words_by_ref -n =: cur words cword
    COMPREPLY=()
    # A blank is typed with a backslash or within quotes, which are not part of the name.
    local typed=("${words[@]:1:cword}")
    mapfile -t lines < <("${words[0]}" complete -- "${typed[@]//[\\\'\"]/}" 2>/dev/null)
    for line in "${lines[@]}"; do
        line=${line%%$'\t'*}
        case $line in
            :files) _filedir ;;
            ":files "*:) # behind log:
                cur=${cur#*"${line#:files }"}
                _filedir
                ;;
            ":files "*) _filedir "${line#:files }" ;;
            *)
                [[ $cur == [\'\"]* ]] || line=$(printf '%q' "$line")
                COMPREPLY+=("$line")
                ;;
        esac
    done
    # What goes on after its end: esc:, steps=
    [[ ${#COMPREPLY[@]} -ne 1 || ${COMPREPLY[0]} != *[=:,] ]] || compopt -o nospace
    # For bash a word ends at = and :
    if [[ $cur == *[=:]* ]]; then
        local before=${cur%"${cur##*[=:]}"}
        COMPREPLY=("${COMPREPLY[@]#"$before"}")
    fi
}
complete -F _codewheel_cli codewheel-cli
