dataset-origin = { $name }: { $source }

dataset-licence = Lizenz: { $licence }{ $cite ->
        [none] {""}
        *[other] ; zitieren: { $cite }
    }

dataset-fetched = Geladen und geprüft: { $n } { $n ->
        [one] Datei
        *[other] Dateien
    }{ $there ->
        [0] {""}
        *[other] ; { $there } waren schon da
    }.
