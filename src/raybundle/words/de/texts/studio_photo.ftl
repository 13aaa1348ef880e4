studio_photo-count = { $n } { $n ->
        [one] Bild
        *[other] Bilder
    }

studio_photo-filter_images = Bilder filtern

studio_photo-rays = { $n } { $n ->
        [one] Strahl
        *[other] Strahlen
    }

studio_photo-p_wrong = Wahrscheinlichkeit, dass der Standpunkt falsch ist: { NUM($percent, digits: 2) } %

studio_photo-not_oriented = nicht orientiert{ $n ->
        [0] {""}
        [one] , { $n } Bildmessung
        *[other] , { $n } Bildmessungen
    }

studio_photo-legend = { $name ->
        [used] verwendet
        [weak] weniger als 3 Strahlen
        [rejected] verworfen
        [control] Passpunkt
        [check] Kontrollpunkt
        [mark] Bildmessung
        [predicted] vorhergesagt, 1 und 3 Sigma
        [beyond] jenseits der Grenze
        *[masked] maskiert
    }

studio_photo-filter = { $filter ->
        [all] alle
        [rejected] verworfene
        [weak] schwache
        [control] Passpunkte
        [worst] größte |w|
        *[none] keine
    }

studio_photo-panes = { $n ->
        [one] { $n } Bild
        *[other] { $n } Bilder nebeneinander
    }

studio_photo-pane_count = Anzahl der Bilder

studio_photo-linked = gekoppelt
    .title = Alle Bilder gemeinsam verschieben und vergrößern

studio_photo-loupe = Lupe
    .title = Den Ausschnitt am Zeiger vergrößern (L)

studio_photo-targets = Zielmarken
    .title = Die in den Aufnahmen gefundenen Zielmarken zeichnen

studio_photo-residuals = Verbesserungen
    .title = Länge einer Verbesserung von 1 px auf dem Bildschirm

studio_photo-brightness = Helligkeit
    .title = Doppelklick setzt zurück

studio_photo-contrast = Kontrast
    .title = Doppelklick setzt zurück

studio_photo-last_open = Das letzte Bild bleibt offen.

studio_photo-no_point_here = Am Zeiger oder Fadenkreuz ist kein Bildpunkt.

studio_photo-canvas = Aufnahme { $image }: Pfeiltasten verschieben das Fadenkreuz, Eingabe misst, ? zeigt alle Tasten

studio_photo-pane = Bild { $image }

studio_photo-turn_left = { $image } nach links drehen

studio_photo-turn_right = { $image } nach rechts drehen

studio_photo-pixels = { $image } in voller Auflösung zeigen

studio_photo-fit = Ganz
    .title = { $image } ganz zeigen

studio_photo-close = { $image } schließen

studio_photo-unknown = Die Datei der Aufnahme ist unbekannt.
    .do = Den Ordner angeben: { OPTION("photos") }.

studio_photo-outside = Diese Stelle liegt außerhalb der Aufnahme.

studio_photo-residual = v { $vx }; { $vy } px, |w| { $w }, { $n } { $n ->
        [one] Strahl
        *[other] Strahlen
    }

studio_photo-rejected = verworfen: { $cause }

studio_photo-by_hand = von Hand
