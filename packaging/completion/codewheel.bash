# SPDX-License-Identifier: GPL-3.0-or-later
# Completion of codewheel in bash: its options and the files it opens, as its help names them.
_codewheel() {
    local cur help
    _get_comp_words_by_ref cur
    help=$("${COMP_WORDS[0]}" --help 2>/dev/null)
    if [[ $cur == -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$(grep -oE -- '--[a-z-]+' <<<"$help")" -- "$cur")
    else
        _filedir "@($(grep -oE '\*\.[a-z]+' <<<"$help" | cut -c3- | paste -sd'|'))"
    fi
}
complete -F _codewheel codewheel
