epochs_names = { $moved } von { $n } gemeinsamen Punkten von { $epochs } haben sich bewegt, mehr als die Hälfte.
    .why = Der Test kann nicht entscheiden, welche Hälfte stabil ist; oft sind die Namen falsch.
    .do = Vertauschte oder verschobene Punktnamen prüfen oder die Datumspunkte nennen: { OPTION("datum", "NAMES") }.
