option-exclusive = { OPTION($first) } und { OPTION($second) } schließen sich aus.
    .do = Eines davon angeben.

option-missing = { OPTION($setting, $value) } fehlt.
    .do = Es ergänzen.
