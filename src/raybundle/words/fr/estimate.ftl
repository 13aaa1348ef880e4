estimate-no_list = Les paramètres à estimer doivent être énumérés.

estimate-neither_auto_nor_list = { $value } n'est ni "auto" ni une liste de paramètres.
