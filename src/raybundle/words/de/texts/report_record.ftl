report_record-title = Dokumentationsblatt

report_record-entry = Eintrag

report_record-record = Angabe

report_record-part = { $part ->
        [object] Objekt
        [recording] Aufnahme
        *[delivery] Übergabe
    }

report_record-from_photographs = aus den Aufnahmen

report_record-sources = Objekt: nach dem Core Data Index to Historic Buildings and Monuments (Europarat, CIDOC).
    .why = Aufnahme: nach den 3x3-Regeln der CIPA.

report_record-name = { $name ->
        [title] Titel
        [client] Auftraggeber
        [operator] Bearbeiter
        [object] Objekt
        [place] Ort
        [date] Datum
        [instruments] Geräte
        [rights] Rechte
        [reference] Nachweise
        [kind] Art
        [dating] Datierung
        [persons] Personen
        [materials] Materialien
        [condition] Zustand
        [protection] Schutz
        [description] Beschreibung
        [purpose] Zweck
        [conditions] Bedingungen
        [control] Passpunkte und Maßstab
        *[archive] Archiv
    }

report_record-meaning = { $name ->
        [title] Titel der Übergabe
        [client] Auftraggeber
        [operator] Fotograf oder Bearbeiter der Ausgleichung
        [object] Name des Objekts
        [place] Anschrift, Gemeinde, Land
        [date] Datum der Aufnahmen
        [instruments] Kameras, Objektive, Empfänger, Maßstäbe
        [rights] Lizenz oder Eigentümer des Ergebnisses
        [reference] Inventar- und Auftragsnummern
        [kind] Art und Nutzung des Objekts
        [dating] Epoche, Jahrhundert oder Jahre
        [persons] Urheber, Eigentümer, Veränderungen durch
        [materials] Materialien und Techniken
        [condition] Zustand des Objekts
        [protection] rechtlicher Status
        [description] weitere Beschreibung
        [purpose] Zweck der Dokumentation
        [conditions] Wetter, Licht und Zugang
        [control] Messung von Maßstab, Passpunkten und Lotrichtung
        *[archive] Verwahrer der Dokumentation und Ort
    }
