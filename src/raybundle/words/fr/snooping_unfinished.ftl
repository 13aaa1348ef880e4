snooping_unfinished = La recherche de fautes s'est arrêtée après { $rounds } tours ; des fautes présumées restent.
