record-empty = Das Aufnahmeblatt hat keinen Eintrag.

record-next = { $oriented ->
        [yes] raybundle orient noch einmal ausführen: der Bericht übernimmt das Aufnahmeblatt.
        *[no] raybundle orient ausführen: der Bericht übernimmt das Aufnahmeblatt.
    }
