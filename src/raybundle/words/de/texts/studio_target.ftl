studio_target-found = gefunden

studio_target-used = verwendet

studio_target-rejected = verworfen

studio_target-apart = nicht im Bildverband

studio_target-unidentified = unbenannt

studio_target-fate = { $fate ->
        [used] verwendet
        [rejected] verworfen
        [apart] nicht im Bildverband
        *[unidentified] unbenannt
    }

studio_target-legend = { $fate ->
        [used] Zielmarke verwendet
        [rejected] Zielmarke verworfen
        [apart] Zielmarke nicht im Bildverband
        *[unidentified] Kreis ohne Namen
    }

studio_target-median_sigma = Median von Sigma [px]

studio_target-source = Quelle

studio_target-origin = { $origin ->
        [calibrate] von calibrate gespeichert
        *[studio] im Studio gefunden
    }

studio_target-not_found = noch nicht gesucht

studio_target-family = Familie

studio_target-families = Bekannte Familien: { $names }.

studio_target-family_missing = Die Familie der aufgenommenen Zielmarken angeben.

studio_target-name_family = Die Familie der Zielmarken unter Entscheiden, Zielmarken angeben.

studio_target-none_stored = Keine Zielmarken dieser Familie sind gespeichert.
    .do = Sie in allen Aufnahmen suchen oder eine Aufnahme mit ihren Zielmarken zeigen.

studio_target-find = In allen Aufnahmen suchen
    .title = Die Zielmarken im Hintergrund suchen; Anhalten beendet die Suche

studio_target-finding = Zielmarken werden gesucht.

studio_target-found_in = Zielmarken gefunden in { $n ->
        [one] { $image }
        *[other] { $n } Aufnahmen
    }.

studio_target-in_image = Zielmarken in { $image }

studio_target-by_photograph = Zielmarken je Aufnahme

studio_target-of_image = Zielmarken in { $image }: { $n }

studio_target-show = { $image } mit Zielmarken zeigen

studio_target-sigma = Sigma [px]

studio_target-semi_axis_a = Halbachse a [px]

studio_target-semi_axis_b = b [px]

studio_target-sheet = Bogen zum Drucken

studio_target-sheet_note = Ohne Skalierung drucken und den Maßstab auf dem Papier messen.
    .why = raybundle calibrate liest die TOML-Datei des Bogens.

studio_target-make_sheet = Bogen erzeugen
    .title = Ein PDF in wahrer Größe und eine TOML-Datei seines Inhalts erzeugen

studio_target-sheet_made = Der Bogen ist erzeugt.
