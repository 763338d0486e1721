import './history.css';

/** The script of a history's page. */
window.limitgauge = { ready: Promise.resolve() };
