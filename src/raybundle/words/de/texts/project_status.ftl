project_status-without_workers = { $shards ->
    [yes] CPU s und Speicher gelten
   *[no] Der Speicher gilt
 } für den Rechner des Befehls, ohne Worker.

project_status-running = { $state ->
        [working] In Arbeit
        [stopped] Abgebrochen
        *[waiting] Wartet auf Anteile
    }: { $stage }, { $done } von { $total } fertig ({ $at }).

project_status-works = Ein Lauf arbeitet gerade darin.

project_status-listed = Aufgaben für Anteile: { $n }, davon { $done } erledigt.

project_status-products = Produkte: { $size } im Ordner{ $store ->
        [none] {""}
        *[other] , weitere in { $store }
    }.

project_status-deletable = { $folder } kann gelöscht werden; der nächste Lauf misst dann alles neu.

project_status-surface = Oberfläche:

project_status-parts = { $folder }: Teile { $in_use ->
        [yes] einer laufenden Ausgleichung
        *[no] einer abgebrochenen Ausgleichung
    } ({ $size }{ $n ->
        [0] {""}
        *[other] {" "}und in { $stores }
    }).
    .do = { $in_use ->
            [yes] {""}
            *[no] Mit demselben Befehl fortsetzen oder den Ordner löschen.
        }

project_status-begun = Projekt begonnen.

project_status-exported = Messungen exportiert.

project_status-action = Aktion { $seq }: { $verb }{ $of ->
        [0] {""}
        *[other] {" "}von Aktion { $of }, { $of_verb } { LIST($arguments, most: 12) }
    }.
