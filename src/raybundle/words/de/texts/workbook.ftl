workbook-written = Arbeitsmappe: { $n } { $n ->
        [one] Tabellenblatt
        *[other] Tabellenblätter
    } ({ $names }).

workbook-left_out = { $name } { $cause ->
        [parquet] ist als Parquet gespeichert, weil die Tabelle zu lang für ein Blatt ist.
        [empty] hat keine Zeilen.
        *[rows] hat mehr Zeilen, als ein Blatt fasst ({ $rows }).
    }
