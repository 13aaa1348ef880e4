parquet-damaged = Die Parquet-Datei ist beschädigt oder unvollständig.
    .do = Die Datei neu schreiben.

parquet-column_lengths = Die Spalten der Parquet-Datei sind verschieden lang.
    .do = Die Datei neu schreiben.

parquet-too_many_rows = Die Parquet-Datei kündigt { $n } Zeilen in { $size_bytes } Bytes an.
    .why = Die Datei ist beschädigt oder keine Tabelle.
    .do = Die Datei neu schreiben.

parquet-not_readable = Die Parquet-Datei ist nicht lesbar ({ $detail }).
    .do = Die Datei neu schreiben.

parquet-no_footer = Die Datei endet nicht wie eine Parquet-Datei.
    .why = Die Datei ist beschädigt, unvollständig oder hat ein anderes Format.
    .do = Die Datei neu schreiben.

parquet-footer_too_large = Die Parquet-Datei kündigt einen Dateifuß von { $footer_bytes } Bytes an; die Datei hat { $size_bytes }.
    .do = Die Datei neu schreiben.

parquet-column_type = Die Spalte enthält { $type }; nötig sind { $numbers ->
        [yes] Zahlen
       *[no] Texte
     }.
    .do = Die Spalte mit einem anderen Typ schreiben.

parquet-encoding = Die Spalte hat die Kodierung { $encoding }, die abgelehnt wird.
    .why = Die Größe der Spalte im Arbeitsspeicher ist vor dem Dekodieren nicht bekannt.
    .do = Die Spalte mit einer anderen Kodierung schreiben.

parquet-group_too_large = Eine Zeilengruppe hat { $n } Zeilen und { $size_bytes } Bytes (Grenzen { $most } und { $limit_bytes }).
    .do = Die Datei mit kleineren Zeilengruppen schreiben.
