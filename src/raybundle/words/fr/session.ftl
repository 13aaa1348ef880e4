session-no_project = Ce n'est pas un dossier de projet, de résultat ou de bloc : block.toml manque.
