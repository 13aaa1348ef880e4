litchi-feet = Les hauteurs sont en pieds.
