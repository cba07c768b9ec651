// The script of the page that `kinegraph edit` serves.
import {start} from './main';
import {open} from './served_engine';

void start(open());
