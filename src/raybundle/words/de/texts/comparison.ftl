comparison-result = { $name }: { $known ->
        [yes] sigma0 { NUM($sigma0, digits: 6) }
        *[no] sigma0 unbekannt
    }, Redundanz { $redundancy }.

comparison-other_rows = Zeilen oder Texte sind verschieden: { $table }.

comparison-same_tables = Bis aufs letzte Bit gleiche Tabellen: { $equal } von { $n }{ $difference ->
        [0] {""}
        *[other] ; größte relative Abweichung { NUM($difference, digits: 1) } ({ $where })
    }.
