journal-nothing_to_undo = Es gibt nichts rückgängig zu machen.
    .do = Die Messung selbst korrigieren oder löschen.

journal-nothing_to_redo = Es gibt nichts wiederherzustellen: Die letzte Aktion wurde nicht rückgängig gemacht.
    .do = Die Aktion von Hand wiederholen.

journal-no_place = In diesem Ordner lässt sich nichts messen.
    .do = Einen Projekt-, Ergebnis- oder Blockordner angeben.

journal-two_journals = Das Projekt hat zwei Messprotokolle: dieses beim Ergebnis und { $other }.
    .do = Eines davon verlegen; ein Messprotokoll gilt unter beiden Namen.

journal-text_too_long = { $entry } { $text } hat { $n } Zeichen; möglich sind höchstens { $most }.
    .do = Einen kürzeren Text wählen.

journal-text_not_printable = { $entry } { $text } enthält nicht druckbare Zeichen.
    .do = Einen anderen Text wählen.

journal-id_used = Die Aktionskennung { $id } ist schon von einer anderen Aktion belegt, { $action } ({ $verb }).
    .do = Jeder Aktion eine eigene Kennung geben.

journal-moved = Das Messprotokoll wurde seit dem Öffnen verlegt, gelöscht oder ersetzt; nichts wurde ergänzt.
    .do = Den Ordner wiederherstellen oder am jetzigen Ort öffnen.

journal-damaged = Aktion { $action } des Messprotokolls ist beschädigt.
    .do = Die Datei aus einer Kopie wiederherstellen.

journal-number_not_finite = { $verb }: Eine Zahl ist nicht endlich.
    .do = Endliche Zahlen angeben.

journal-other_database = Diese Datenbank ist kein Messprotokoll.
    .do = Die Datei an einen anderen Ort verlegen.

journal-schema = Das Messprotokoll wurde von einer anderen Version geschrieben (Schema { $found }; diese Version liest { $read }).
    .do = Jene Version verwenden.

journal-foreign_action = Aktion { $action } des Messprotokolls ist ungültig.
    .do = Die Datei aus einer Kopie wiederherstellen.

journal-read_only = Messen ist nicht möglich: Der Ordner { $folder } ist schreibgeschützt.
    .why = Sein Inhalt lässt sich ansehen.
    .do = Schreiben darin erlauben oder ihn an einen anderen Ort kopieren und neu öffnen.

journal-not_usable = Das Messprotokoll ist nicht benutzbar ({ $detail }).
    .do = { $cause ->
        [locked] Das andere Programm beenden, das die Datei hält, und erneut versuchen
        [full] Speicherplatz freigeben und erneut versuchen
        [damaged] Die Datei aus einer Kopie wiederherstellen oder verlegen
        [read_only] Schreiben im Ordner erlauben und den letzten Schritt wiederholen
       *[other] Prüfen, ob der Ordner existiert und beschreibbar ist
     }.
