"""What is photographed: surfaces and terrain, as geometry without files."""
