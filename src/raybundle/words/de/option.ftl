option-exclusive = { OPTION($first) } und { OPTION($second) } schließen sich aus.
    .do = Eines davon angeben.

option-missing = { OPTION($setting, $value) } fehlt.
    .do = Es ergänzen.

option-needs = { OPTION($setting) } braucht { OPTION($other) }.
    .do = Beides angeben oder beides weglassen.

option-one_of = Genau eines von { OPTION($first) } und { OPTION($second) } ist nötig.
    .do = Eines davon angeben.
