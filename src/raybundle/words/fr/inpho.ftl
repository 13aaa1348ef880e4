inpho-not_closed = Le dernier bloc PHOTO n'est pas fermé par END : le fichier est incomplet.
