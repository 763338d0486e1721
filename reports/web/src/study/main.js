import './study.css';

/** The script of a study's page. */
window.limitgauge = { ready: Promise.resolve() };
