// The script of the static site's page.
import {start} from '../src/main';
import {open} from './worker_engine';

void start(open());
