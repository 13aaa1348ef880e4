scale_unchecked = Der Maßstab beruht auf { $n ->
        [one] einer Maßstabsstrecke
       *[other] { $n } Maßstabsstrecken
     } ({ $ids }); keine weitere Länge bestätigt ihn.
    .why = { $n ->
        [one] Ist ihre Länge falsch, sind alle Längen um denselben Faktor falsch, und keine Verbesserung zeigt es.
       *[other] Ist eine dieser Längen falsch, sind auch andere Längen falsch, und keine Verbesserung zeigt es.
     }
    .do = Eine zweite Maßstabsstrecke oder eine gemessene Länge zwischen zwei Punkten ergänzen.
