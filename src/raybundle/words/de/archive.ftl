archive-file_missing = Das Archiv hat keine Datei { $name }.
    .do = Prüfen, ob es die richtige Datei ist.

archive-file_too_large = { $name } im Archiv hat { $size_bytes } Bytes; höchstens { $limit_bytes } werden gelesen.
    .do = Die Datei vereinfachen.

archive-not_unpacked = Das Archiv lässt sich nicht entpacken ({ $detail }).
    .do = Die Datei erneut kopieren oder exportieren.
