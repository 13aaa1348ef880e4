project-folder_not_empty = Der Ordner existiert und ist weder leer noch ein Projekt.
    .do = Ein anderes { OPTION("out") } wählen.

project-not_readable = Die Projektdatenbank ist nicht lesbar ({ $detail }).
    .why = { $damaged ->
        [yes] Merkmale gehen nicht verloren; Paare werden neu zugeordnet.
       *[no] Ein anderes Programm benutzt vielleicht das Projekt.
     }
    .do = { $damaged ->
        [yes] Diese Datei löschen und denselben Befehl erneut ausführen
       *[no] Andere Programme schließen, die das Projekt benutzen, oder ein anderes { OPTION("out") } wählen
     }.

project-schema = Das Projekt wurde von einer anderen Version geschrieben (Schema { $found }; diese Version liest { $read }).
    .do = In einen neuen Ordner orientieren.

project-no_database = Das ist kein Projektordner: project.db fehlt.
    .do = Ein Projekt mit raybundle orient beginnen.

project-in_use = Ein anderer Lauf ist in diesem Projekt aktiv.
    .do = Auf ihn warten oder ein anderes { OPTION("out") } wählen.

project-table_not_writable = Die Tabelle [{ $table }] lässt sich nicht schreiben, ohne eine andere zu ändern.
    .do = Die Tabelle von Hand schreiben, mit einfachen Überschriften und einzeiligen Texten.

project-no_run = Das ist kein Projektordner, oder darin wurde kein Lauf begonnen.
    .do = Zuerst den Befehl ausführen, der die Aufgaben beginnt.

project-not_writable = In den Ordner lässt sich nicht schreiben ({ $detail }).
    .why = { $kept ->
        [yes] Fertige Produkte bleiben erhalten; der Lauf wird dort fortgesetzt.
       *[no] Noch ist kein Produkt fertig.
     }
    .do = { $cause ->
        [full] Speicherplatz freigeben und denselben Befehl erneut ausführen
        [occupied] Die Datei oder den Ordner dieses Namens verlegen und denselben Befehl erneut ausführen
       *[other] Einen Ordner mit Schreibrecht wählen
     }.

project-photographs_missing = Aufnahmen des Projekts, die fehlen: { $n } ({ LIST($names, most: 3) }).
    .do = Die fehlenden Aufnahmen ergänzen oder ein anderes Projekt wählen.

project-not_a_project = Dies ist kein Projektordner.
    .do = Den Ordner eines Projekts oder einen neuen Namen angeben; orient verwendet die Angaben dann im neuen Projekt.

project-missing = Es gibt kein solches Projekt.
    .do = { $n ->
        [0] Eines
       *[other] Prüfen, ob { LIST($near, most: 1) } gemeint ist, oder eines
     } mit einer Angabe wie { OPTION("object", "NAME") } und { OPTION("new", "True") } beginnen.

project-no_result = Das Projekt hat kein aktuelles Ergebnis.
    .do = Die Aufnahmen orientieren, nach dem Löschen eines Ergebnisses erneut: Fertige Schritte kommen aus dem Projekt.

project-at_url = Ein Projekt kann nicht an einer URL liegen; sein Ordner muss auf diesem Rechner sein.
    .do = Einen Ordner angeben, und die URL für die Produkte: { OPTION("store", "URL") }.

project-base_missing = Das Ergebnis ohne gemessene Punkte, in das diese eingefügt werden, fehlt oder ist beschädigt.
    .do = `raybundle orient` noch einmal ausführen: es erzeugt das Ergebnis neu und gleicht mit den Punkten aus.

project-result_damaged = Das aktuelle Ergebnis des Projekts ist beschädigt.
    .do = Diesen Ordner löschen und `raybundle orient` noch einmal ausführen.{ $n ->
        [0] {""}
       *[other] {" Frühere stehen im Ordner results."}
    }
