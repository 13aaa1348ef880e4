studio_run-title = Lauf aller Schritte

studio_run-begin = { $name } starten
    .title = Alle Schritte im Hintergrund laufen lassen; gespeicherte werden nicht wiederholt

studio_run-stop = Anhalten
    .title = Zwischen zwei Aufgaben anhalten; fertige sind gespeichert

studio_run-begun = Die Schritte laufen.

studio_run-progress = Fortschritt dieses Teilschritts

studio_run-stages = Schritte

studio_run-stage = Schritt

studio_run-state = Zustand

studio_run-output = Ausgabe des Befehls

studio_run-settings = Einstellungen

studio_run-settings_note = Einstellungen des letzten Laufs in diesem Ordner; geänderte sind hervorgehoben.
    .why = Bildmessungen bleiben und werden beim nächsten Ausgleichen verwendet.

studio_run-settings_stored = Einstellungen des nächsten Laufs gespeichert.

studio_run-photos_help = Ordner und Dateien der Aufnahmen. Namen mit Leerzeichen in Anführungszeichen setzen.

studio_run-ended = { $outcome ->
        [done] Fertig
        [stopped] Angehalten
        *[failed] Gescheitert
    } nach { $time }

studio_run-stopped = Angehalten; fertige Schritte sind gespeichert, und ein weiterer Lauf fährt dort fort.

studio_run-stopping = Anhalten nach der laufenden Aufgabe: { $step }

studio_run-going = { $step }: { $percent } %{ $rest ->
        [none] {""}
        *[other] , noch { $rest }
    }; { $time } insgesamt

studio_run-status = Der Befehl endete mit Status { $status }.

studio_run-unreadable = Das neue Ergebnis ist nicht lesbar: { $detail }

studio_run-stage_state = { $state ->
        [at_work] läuft
        [done] fertig
        [kept] aus einem früheren Lauf
        [not_needed] nicht nötig
        *[waiting] wartet
    }

studio_run-stage_name = { $stage ->
        [photographs] Aufnahmen
        [features] Merkmale
        [matching] Zuordnung
        [start] Näherungsorientierung
        [precision] Kleinste-Quadrate-Zuordnung
        [least_squares_matching] Kleinste-Quadrate-Zuordnung
        [adjustment] Ausgleichung
        [adjusting] Ausgleichung
        [report] Bericht
        [targets] Zielmarken
        [verdict] Urteil
        [orienting] Orientierung
        [orienting_all_images_at_once] Orientierung aller Bilder
        [statistics] Statistik
        [covariances] Kovarianzen
        [control] Passpunkte
        [what_was_photographed] Erkennung der Zielmarken
        [cross_validation] Kreuzvalidierung
        [reading_photographs] Lesen der Aufnahmen
        [writing] Schreiben
        [tracks] Verknüpfungspunkte
        [cleaning] Entfernen grober Fehler
        [weights] Gewichte
        [writing_tables] Schreiben der Tabellen
        [beginning] Beginn
        *[other] { $name }
    }
