studio-page_of_folder = what = { $page } braucht eine Ausgleichung, keinen Ordner.
    .do = what="studio" verwenden oder report.html des Ordners öffnen.

studio-path_of_folder = Ein Pfad ist angegeben, aber das Ergebnis ist schon in einem Ordner.
    .do = path weglassen.

studio-not_started = Das Studio von { $folder } endete mit Status { $status }{ $n ->
        [0] { " " }ohne Ausgabe
       *[other] : { $detail }
     }
    .do = Auf der Befehlszeile raybundle studio { $folder } ausführen und den gezeigten Fehler beheben.

studio-no_figure = Es gibt keine Abbildung { $number }; es sind { $n }, ab 0 gezählt.
    .do = { $n ->
            [0] Den Block erst ausgleichen
            *[other] Eine Zahl unter { $n } angeben
        }.

studio-no_adjustment = Es gibt noch keine Ausgleichung.
    .do = Zuerst ausgleichen oder das Ende der laufenden Ausgleichung abwarten.

studio-no_photographs = Kein Ordner und keine Datei mit Aufnahmen ist angegeben.
    .do = Den Ordner der Aufnahmen im ersten Feld angeben.

studio-nothing_to_run = In diesem Ordner können keine Schritte laufen; sein Block lässt sich ausgleichen.
    .do = Einen Projektordner von orient, einen Ergebnisordner von calibrate oder einen Ordner mit Aufnahmen öffnen.

studio-busy = Ein Lauf oder eine Ausgleichung läuft bereits.
    .do = Anhalten oder das Ende abwarten.

studio-port_in_use = Port { $port } ist nicht verwendbar ({ $detail }).
    .do = { OPTION("port") } weglassen; dann wird ein freier Port verwendet.

studio-adjustment_not_stored = Ausgleichung { $number } ist nicht gespeichert; { $n ->
        [0] keine ist gespeichert
       *[other] gespeichert: { LIST($stored, most: 20) }
    }.
    .do = { $n ->
            [0] Den Block erst ausgleichen
            *[other] Eine der gespeicherten Ausgleichungen wählen
        }.

studio-adjustment_without_page = Ausgleichung { $number } hat keine { $name }.
    .do = Neu ausgleichen; dabei wird die Seite geschrieben.

studio-photograph_file_unknown = Die Datei dieser Aufnahme ist nicht bekannt.
    .do = Das Studio mit dem Ordner der Aufnahmen starten: { OPTION("photos") }.

studio-no_level = Es gibt keine Stufe { $level }; es sind { $n }, ab 0 gezählt.
    .do = Eine Stufe unter { $n } angeben.

studio-tile_outside = Kachel { $across }, { $down } der Stufe { $level } liegt außerhalb der Aufnahme.
    .do = Die Seite neu laden; in einem Programm eine Kachel innerhalb der Aufnahme angeben.
