project-folder_not_empty = Le dossier existe et n'est ni vide ni un projet.

project-not_readable = La base du projet n'est pas lisible ({ $detail }).

project-schema = Le projet a été écrit par une autre version (schéma { $found } ; celle-ci lit { $read }).

project-no_database = Ce n'est pas un dossier de projet : project.db manque.

project-in_use = Une autre exécution est active dans ce projet.

project-table_not_writable = La table [{ $table }] ne peut pas être écrite sans en changer une autre.

project-no_run = Ce n'est pas un dossier de projet, ou aucune exécution n'y a commencé.

project-not_writable = Le dossier ne peut pas être écrit ({ $detail }).

project-photographs_missing = Photographies du projet qui manquent : { $n } ({ LIST($names, most: 3) }).

project-not_a_project = Ce n'est pas un dossier de projet.

project-missing = Il n'y a pas de tel projet.

project-no_result = Le projet n'a pas de résultat actuel.

project-at_url = Un projet ne peut pas se trouver à une URL ; son dossier doit être sur cette machine.

project-base_missing = Le résultat sans points mesurés, auquel ceux-ci sont ajoutés, manque ou est endommagé.

project-result_damaged = Le résultat actuel du projet est endommagé.
