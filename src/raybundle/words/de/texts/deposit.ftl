deposit-written = Gepackt: { $n } Dateien, { NUM($mb, digits: 3) } MB.

deposit-content = { $entry ->
        [result] aktuelles Ergebnis: Bericht, Tabellen, Block; seine README.txt nennt jede Datei und Spalte
        [surface] Produkte der Oberfläche
        [facade] Produkte der Fassade
        [photographs] Fotos
        [project_toml] Parameter der Läufe und Aufnahmebogen
        [measurements_json] Journal des von Hand Gemessenen
        [photographs_sha256] Prüfsummen der Fotos
        [checksums_sha256] Prüfsummen aller Dateien: sha256sum -c checksums.sha256
       *[ro_crate_metadata_json] Beschreibung des Pakets (RO-Crate 1.1)
    }

deposit-description = Photogrammetrische Aufnahme: Orientierungen, Koordinaten, Genauigkeit. { LIST($of, most: 3) }

deposit-adjustment = Orientierung und Bündelausgleichung
