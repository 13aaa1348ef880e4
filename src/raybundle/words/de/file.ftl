file-not_readable = Die Datei ist nicht lesbar ({ $detail }).
    .do = Pfad und Zugriffsrechte prüfen.

file-missing = Diese Datei oder diesen Ordner gibt es nicht.
    .do = Den Pfad prüfen.

file-memory = Die Datei braucht mehr Arbeitsspeicher, als vorhanden ist.
    .do = Prüfen, ob die Datei vollständig ist und das richtige Format hat.

file-not_computable = Mit den Zahlen dieser Datei ist keine Berechnung möglich.
    .why = Die Datei ist wahrscheinlich beschädigt.
    .do = Die Datei neu exportieren.

file-link_broken = Diese Verknüpfung zeigt auf { $target }, das es nicht gibt.
    .do = Die Verknüpfung korrigieren oder löschen.

file-link_loop = Eine Verknüpfung in diesem Pfad zeigt auf sich selbst.
    .do = Die Verknüpfung löschen oder einen anderen Pfad wählen.

file-impossible_name = Dieser Name ist für eine Datei nicht möglich.
    .do = Den Pfad prüfen.

file-not_a_file = Das ist { $kind ->
        [folder] ein Ordner
        [pipe] eine Pipe
        [socket] ein Socket
       *[device] ein Gerät
     }, keine Datei.
    .do = Den Namen einer Datei angeben.

file-too_large = Die Datei hat { $size_bytes } Bytes; höchstens { $limit_bytes } werden gelesen.
    .do = Prüfen, ob es die richtige Datei ist.

file-changed = Die Datei änderte sich während des Lesens.
    .do = Warten, bis sie vollständig ist, und es erneut versuchen.

file-control_character = Die Datei enthält das Steuerzeichen { $byte }; sie ist keine Textdatei.
    .do = Prüfen, ob die Datei beschädigt ist.

file-not_utf8 = Das Byte { $byte } ist nicht UTF-8{ $utf16 ->
        [yes] { " " }(die Datei scheint UTF-16 zu sein)
       *[no] { "" }
     }.
    .do = Die Datei in der Kodierung UTF-8 speichern.

file-nested_too_deeply = Werte sind tiefer als { $most } Ebenen verschachtelt.
    .do = Prüfen, ob es die richtige Datei ist.

file-number_too_long = Eine Zahl hat zu viele Ziffern.
    .do = Prüfen, ob die Datei beschädigt ist.

file-not_understood = Der Inhalt ist nicht auswertbar ({ $detail }).
    .do = Prüfen, ob die Datei vollständig ist.

file-exists = Die Datei gibt es schon.
    .do = Einen anderen Namen wählen oder das Überschreiben erlauben: --overwrite, in Python raybundle.overwriting().

file-is_a_folder = Das ist ein Ordner.
    .do = Den Namen einer Datei angeben.

file-not_writable = Hier kann nicht geschrieben werden ({ $detail }).
    .do = { $refused ->
        [yes] Einen Ordner mit Schreibrecht wählen
       *[no] Speicherplatz freigeben oder einen anderen Ordner wählen
     }.

file-created_meanwhile = Ein anderer Lauf hat diesen Namen inzwischen angelegt; das Ergebnis dieses Laufs ist verworfen.
    .do = Einen anderen Namen wählen und den Lauf wiederholen.

file-no_images = Die Datei enthält keine Bilder.
    .do = Prüfen, ob es die richtige Datei ist.

file-empty = Die Datei ist leer.
    .do = Prüfen, ob sie vollständig ist.

file-suffix = Der Name muss auf { LIST($known, most: 20) } enden.
    .do = Einen solchen Namen wählen.

file-name_not_utf8 = Dieser Name ist kein gültiges UTF-8.
    .why = Das Ergebnis enthält seinen Namen in UTF-8.
    .do = { OPTION("out") } anders wählen.

file-read_by_command = Diese Datei ist Eingabe des Befehls; sie wird nicht überschrieben.
    .do = Einen anderen Namen wählen.

file-hdf5_damaged = Die HDF5-Datei ist beschädigt oder unvollständig ({ $detail }).
    .do = Die Datei erneut beschaffen.
