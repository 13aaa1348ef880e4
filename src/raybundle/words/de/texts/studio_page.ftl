studio_page-tabs = Ansichten

studio_page-images = Bilder

studio_page-space = Raum

studio_page-tables = Tabellen

studio_page-epochs = Tage

studio_page-decide = Entscheiden

studio_page-journal = Protokoll

studio_page-undo = Rückgängig
    .title = Die letzte Aktion rückgängig machen (Strg Z)

studio_page-redo = Wiederholen
    .title = Die Aktion wiederholen (Strg Umschalt Z)

studio_page-adjust = Ausgleichen
    .title = Den Bildverband mit allen Bildmessungen orientieren und ausgleichen

studio_page-report = Bericht
    .title = Den Bericht einer Ausgleichung zeigen

studio_page-legend = Legende

studio_page-measuring = Messen

studio_page-progress = Fortschritt der Ausgleichung

studio_page-stop = Anhalten
    .title = Die Ausgleichung anhalten

studio_page-last_command = Befehl der letzten Aktion

studio_page-connecting = Verbindung wird hergestellt

studio_page-connected = verbunden

studio_page-connection_lost = Verbindung unterbrochen; neuer Versuch

studio_page-server_status = Der Server antwortete mit Status { $status }.

studio_page-no_answer = Der Server antwortet nicht.

studio_page-actions_wait = Keine Antwort: { $n } { $n ->
        [one] Aktion wartet und wird
        *[other] Aktionen warten und werden
    } erneut gesendet.

studio_page-adjusting = Der Bildverband wird mit den Bildmessungen ausgeglichen.

studio_page-busy = Eine Ausgleichung läuft bereits.

studio_page-adjusted = Ausgeglichen: Sigma0 { $sigma0 }{ $folder ->
        [none] .
        *[other] ; Ergebnis in { $folder }.
    }

studio_page-sigma0 = Sigma0 { $sigma0 }

studio_page-free_scale = Maßstab nicht festgelegt

studio_page-contents = { $kind ->
        [project] Projekt
        [result] Ergebnis
        *[block] Bildverband
    }: { $images } { $images ->
        [one] Bild
        *[other] Bilder
    }, { $points } { $points ->
        [one] Punkt
        *[other] Punkte
    }

studio_page-undone = Rückgängig gemacht: die letzte Aktion.

studio_page-redone = Wiederholt.

studio_page-stopped = Angehalten; nichts wurde geändert.

studio_page-author = Ihr Name

studio_page-copy_all = Alle kopieren
    .title = Alle Befehle kopieren

studio_page-copy = Kopieren
    .title = Den Befehl einer Aktion kopieren

studio_page-copied = Kopiert.

studio_page-not_copied = Der Browser erlaubt das Kopieren nicht.

studio_page-actions = { $n } { $n ->
        [one] Aktion
        *[other] Aktionen
    }, die neueste zuerst; { $shown } gezeigt

studio_page-number = Nr.

studio_page-by = von

studio_page-action = Aktion

studio_page-command = Befehl

studio_page-verb = { $verb ->
        [put] messen
        [move] Bildmessung verschieben
        [remove] Bildmessung entfernen
        [point] Punkt angeben
        [rename] Punkt umbenennen
        [forget] Punkt löschen
        [bar] Maßstabsstrecke angeben
        [unbar] Maßstabsstrecke entfernen
        [line] Linie
        [fiducial] Rahmenmarke
        [datum] Koordinatensystem
        [reject] verwerfen
        [accept] wieder verwenden
        [reject_beyond] über eine Grenze verwerfen
        [parameter] Parameter
        [control] Passpunkttabelle
        [mask] Maske
        [unmask] Maske entfernen
        [draw] zeichnen
        [erase] löschen
        [undo] rückgängig
        [redo] wiederholen
        *[other] { $verb }
    }

studio_page-fault = Fehler des Programms: { $kind }: { $detail }

studio_page-no_page = Diese Seite gibt es nicht.
    .do = Zuerst ausgleichen; dabei werden die Seiten geschrieben.

studio_page-no_sheet = Diesen Bogen gibt es nicht; zuerst einen erzeugen.

studio_page-bad_request = Anfrage: { $name } ist { $kind ->
        [table] keine Tabelle
        [text] kein Text
        [number] keine Zahl
        [list] keine Liste
        [json] kein JSON
        *[id] keine Kennung
    }.

studio_page-bad_characters = Die Anfrage enthält unvollständige Zeichen oder Zahlen, die nicht endlich sind.

studio_page-too_large = Die Anfrage ist zu groß (Grenze { $most } Bytes).

studio_page-id_used = Die Aktionskennung { $id } ist schon vergeben.
    .do = Jeder Aktion eine eigene Kennung geben.

studio_page-other_host = Dieser Name ist nicht der des Studios.
    .do = Die Adresse öffnen, die der Befehl gezeigt hat.

studio_page-other_site = Seiten anderer Herkunft haben keinen Zugang.

studio_page-no_origin = Eine Verbindung ohne ihre Seite hat keinen Zugang.

studio_page-not_json = Anfragen sind JSON.

studio_page-no_session = In diesem Browser gibt es keine Sitzung.
    .do = Die Adresse öffnen, die der Befehl gezeigt hat; sie gilt einmal.
