studio-page_of_folder = what = { $page } braucht eine Ausgleichung, keinen Ordner.
    .do = what="studio" verwenden oder report.html des Ordners öffnen.

studio-path_of_folder = Ein Pfad ist angegeben, aber das Ergebnis ist schon in einem Ordner.
    .do = path weglassen.

studio-not_started = Das Studio von { $folder } endete mit Status { $status }{ $n ->
        [0] { " " }ohne Ausgabe
       *[other] : { $detail }
     }
