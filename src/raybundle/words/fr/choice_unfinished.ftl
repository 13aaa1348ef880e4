choice_unfinished = Le choix des paramètres s'est arrêté après { $steps } étapes ; { $free } paramètres restent libres.
