settings_file-flag_only = { $flag } ist nur auf der Befehlszeile möglich, nicht in einer Datei.
    .do = Den Eintrag löschen.

settings_file-unknown_table = { $table ->
        [yes] [{ $name }] ist nicht die Tabelle eines Befehls
       *[no] { $name } steht in keiner Tabelle eines Befehls und nicht in { $general }
     }.
    .do = { $n ->
        [0] Die Tabelle nach einem Befehl benennen, etwa [adjust]
       *[other] Prüfen, ob { $near } gemeint ist
     }.

settings_file-unknown_option = { $entry }: { $every ->
        [yes] Kein Befehl hat
       *[no] { $command } hat nicht
     } die Option { $flag }.
    .do = { $n ->
        [0] Den Eintrag löschen
       *[other] Prüfen, ob { $near } gemeint ist
     }.
