dataset-name = { $name } ist kein gültiger Name eines Datensatzes.
    .do = Buchstaben, Ziffern und Bindestriche verwenden: Er benennt auch einen Ordner.

dataset-address = { $address } ist keine Adresse eines Ordners.
    .do = http... mit / am Ende angeben.

dataset-file_entry = Eine Datei eines Datensatzes braucht drei Werte.
    .do = [Pfad, Bytes, SHA-256] angeben.

dataset-path_outside = { $path } führt aus dem Ordner des Datensatzes.
    .do = Einen Pfad ohne .. und ohne / am Anfang angeben.

dataset-no_sha256 = { $value } ist keine SHA-256-Prüfsumme.
    .do = 64 Ziffern 0 bis f angeben.

dataset-unknown = Der Datensatz { $name } ist unbekannt.
    .do = Einen von { LIST($known, most: 40) } verwenden.

dataset-checksum = Die Datei hat { $size_bytes } Bytes und die Prüfsumme { $sha256 }; erwartet { $expected_bytes } und { $expected_sha256 }.
    .why = Ein Proxy kann sie verändert haben.
    .do = Den Befehl wiederholen oder { $source } ansehen.

dataset-connection_ended = Die Verbindung endete nach { $received_bytes } von { $size_bytes } Bytes.
    .do = Den Befehl wiederholen; er setzt dort fort.

dataset-connection_broken = Die Verbindung brach ab ({ $detail }).
    .do = Den Befehl wiederholen; er setzt dort fort.

dataset-server_answer = Der Server antwortet { $status } { $detail }.
    .do = { $busy ->
        [yes] Später erneut versuchen
       *[no] Die Adresse prüfen: Die Datei kann verschoben sein
     }.

dataset-no_connection = Es gibt keine Verbindung zu { $host } ({ $detail }).
    .do = Das Netz prüfen (HTTPS_PROXY nennt einen Proxy) und den Befehl wiederholen; er setzt dort fort.

dataset-incomplete = { $name } fehlt; ein Satz hat photos, measured.csv und truth.
    .do = Den Satz neu erzeugen.
