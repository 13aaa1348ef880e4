maxar-no_line_times = Die Tabelle der Zeilenzeiten ist leer.
    .do = Eine vollständige Datei beschaffen.

maxar-entry_count = Einträge { $name }: { $n }; NUMPOINTS ist { $announced }.
    .do = Eine vollständige Datei mit mindestens zwei Einträgen beschaffen.

maxar-gap = Eintrag { NUM($entry, digits: 6) } folgt auf Eintrag { NUM($before, digits: 6) }: Die Tabelle hat eine Lücke.
    .do = Eine vollständige Datei beschaffen.

maxar-camera_backwards = Die Kamera blickt rückwärts: Die dritte Kameraachse ist negativ.
    .do = Das RPC der Datei verwenden; dieser Einbau wird nicht unterstützt.

maxar-no_band = DETECTOR_MOUNTING enthält keinen Kanal.
    .do = Eine vollständige Datei beschaffen.

maxar-no_rigorous_model = Die Datei enthält keine Ephemeride, Lagewinkel und Kamera; nur ihr RPC wird verwendet.

maxar-distortion_not_supported = Die optische Verzeichnung ist nicht 0, was nicht unterstützt wird; das strenge Modell wird nicht verwendet.

maxar-radians_by_rpc = DETROTANGLE { $angle } ist in Radiant: Strenges Modell minus RPC ist { $rms_px } px.
    .why = { $meets ->
     [yes] In Grad sind es { NUM($rms_degrees_px, digits: 4) } px.
     *[no] In Grad trifft kein Strahl das Gelände.
    }

maxar-radians_by_axis = DETROTANGLE { $angle } ist in Radiant: Die Mitte der Zeile liegt { NUM($off_px, digits: 4) } px neben der optischen Achse.
    .why = In Grad sind es { NUM($off_degrees_px, digits: 4) } px.

maxar-degrees_assumed = Die Einheit von DETROTANGLE { $angle } ist nicht angegeben; Grad werden angenommen.
    .why = In Radiant verschieben sich Bildpunkte um bis zu { NUM($apart_px, digits: 4) } px, und zum Vergleich fehlt ein RPC.
