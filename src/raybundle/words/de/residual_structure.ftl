residual_structure = Verbesserungen benachbarter Bildpunkte sind korreliert ({ NUM($correlation, decimals: 2) }, am meisten in { $ids }).
    .why = Standardabweichungen sind mindestens um den Faktor { NUM($factor, decimals: 1) } zu klein{ $few ->
        [yes] ; Serien von { $least_images } Aufnahmen oder mehr zeigen meist { $usual_low } bis { $usual_high }
       *[no] { "" }
     }. Die innere Orientierung hat sich womöglich zwischen den Bildern geändert (Bildstabilisator, Fokussierung, Zoom).
    .do = Beim Fotografieren Objektiv und Fokussierung fixieren und die Verbesserungen im Bericht prüfen.

residual_structure-shared = Bildpunkte haben gemeinsame, langsam veränderliche Fehler; Standardabweichungen sind bis zu { NUM($largest, digits: 2) }-mal zu klein.
    .why = Die Standardabweichungen setzen unabhängige Fehler voraus.
    .do = Mit { OPTION("noise", "fields") } ausgleichen.

residual_structure-fields = Glatte, von Bild zu Bild verschiedene Fehler betragen { NUM($tau_px, digits: 2) } px.

residual_structure-focus = Fehler durch veränderliche Fokussierung betragen { NUM($focus_px, digits: 2) } px.

residual_structure-neighbours = Gemeinsame Fehler benachbarter Punkte betragen das { NUM($phi, digits: 2) }-Fache der Varianz.

residual_structure-times = Standardabweichungen { $object ->
        [interior] der inneren Orientierung
        *[points] der Objektpunkte
    } sind { NUM($factor, digits: 2) }-mal zu klein (Median).

residual_structure-sample = Diese Werte sind aus einem Teil des Blocks geschätzt: { $images } für sich ausgeglichene Bilder.

residual_structure-with_fields = Mit Rauschfeldern ({ OPTION("noise", "fields") }, wie bei `orient`) enthalten die Standardabweichungen diese Fehler.
