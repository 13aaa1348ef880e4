session-no_project = Das ist kein Projekt-, Ergebnis- oder Blockordner: block.toml fehlt.
    .why = Es wird hier, in block und in result/block gesucht.
    .do = Den Ordner angeben, den { OPTION("out") } nannte.
