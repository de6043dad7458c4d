struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_5 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_6 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: f32,
member_11: f32,
member_12: f32,
}
struct type_7 {
member: type_5,
member_1: f32,
}
struct type_8 {
member: type_7,
member_1: type_5,
}
struct type_9 {
member: type_8,
member_1: type_8,
}
struct type_10 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: f32,
member_4: u32,
member_5: u32,
member_6: u32,
}
struct type_11 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_10,
}
struct type_12 {
member: type_5,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
}
struct type_13 {
member: u32,
member_1: u32,
}
struct type_15 {
member: array<f32>,
}
struct type_18 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_19 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: u32,
member_12: u32,
member_13: u32,
member_14: f32,
member_15: f32,
member_16: f32,
}
struct type_20 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: u32,
}
struct type_21 {
member: f32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
}
struct type_22 {
member: type_5,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_23 {
member: type_2,
member_1: type_13,
member_2: type_4,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: f32,
member_8: type_5,
member_9: type_5,
member_10: type_11,
member_11: type_18,
member_12: type_19,
member_13: type_20,
member_14: type_9,
member_15: type_6,
member_16: type_12,
member_17: u32,
member_18: type_21,
member_19: type_22,
}
struct type_24 {
member: type_23,
}
struct type_25 {
member: type_5,
member_1: type_5,
}
struct type_26 {
member: f32,
member_1: f32,
}
struct type_27 {
member: i32,
member_1: i32,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_24;
@group(0) @binding(2)
var<storage, read_write> global_2: type_15;
@group(0) @binding(1)
var<storage> global_3: type_15;
fn function_() {
var local: i32;
var local_1: i32;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var local_6: i32;
var local_7: i32;
var local_8: i32;
var local_9: i32;
var local_10: i32;
var local_11: i32;
var local_12: i32;
var local_13: i32;
var local_14: i32;
var phi_2152_: type_26;
var phi_2409_: type_27;
var phi_2543_: i32;
var phi_2546_: bool;
var phi_2563_: i32;
var phi_2564_: i32;
var phi_3773_: type_25;
var phi_3774_: type_25;
var phi_3777_: i32;
var phi_3780_: bool;
var phi_3778_: i32;
var phi_3781_: bool;
var phi_3876_: bool;
var phi_3877_: bool;
var phi_2544_: i32;
var phi_2547_: bool;
var phi_3879_: bool;
var local_15: bool;
var local_16: bool;
let _e61 = global;
let _e69 = global_1.member.member;
if (_e61.x < _e69.member) {
if (_e61.y < _e69.member_1) {
let _e77 = ((_e61.y * _e69.member) + _e61.x);
let _e78 = bitcast<i32>(_e77);
let _e80 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e82 = select(_e80, _e78, (_e78 < _e80));
let _e88 = global_2.member[bitcast<u32>(select(0i, _e82, (_e82 > 0i)))];
let _e92 = global_1.member.member.member;
let _e99 = global_1.member.member.member_1;
let _e105 = global_1.member.member_12.member_4;
let _e109 = global_1.member.member_12.member_6;
let _e111 = bitcast<i32>((_e105 * _e109));
local_12 = _e111;
local_13 = bitcast<i32>(((_e61.y * _e92) + _e61.x));
local_14 = bitcast<i32>((_e92 * _e99));
let _e112 = local_12;
let _e113 = local_14;
let _e116 = local_13;
let _e117 = ((_e112 + (18i * _e113)) + _e116);
let _e119 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e121 = select(_e119, _e117, (_e117 < _e119));
let _e126 = global_3.member[bitcast<u32>(select(0i, _e121, (_e121 > 0i)))];
let _e127 = local_12;
let _e128 = local_14;
let _e131 = local_13;
let _e132 = ((_e127 + (19i * _e128)) + _e131);
let _e134 = select(_e119, _e132, (_e132 < _e119));
let _e139 = global_3.member[bitcast<u32>(select(0i, _e134, (_e134 > 0i)))];
let _e141 = local_12;
let _e142 = local_14;
let _e145 = local_13;
let _e146 = ((_e141 + (20i * _e142)) + _e145);
let _e148 = select(_e119, _e146, (_e146 < _e119));
let _e153 = global_3.member[bitcast<u32>(select(0i, _e148, (_e148 > 0i)))];
if (select(0u, 3u, ((((_e126 + _e139) + _e153) > 0f) && (_e88 <= 0f))) > 1u) {
let _e160 = bitcast<i32>(_e92);
let _e161 = bitcast<i32>(_e99);
let _e162 = bitcast<i32>(_e61.x);
let _e163 = bitcast<i32>(_e61.y);
let _e164 = (_e160 * _e161);
let _e166 = ((_e163 * _e160) + _e162);
local_9 = _e111;
local_10 = _e166;
local_11 = _e164;
let _e167 = local_9;
let _e168 = local_10;
let _e169 = (_e167 + _e168);
let _e171 = select(_e119, _e169, (_e169 < _e119));
let _e176 = global_3.member[bitcast<u32>(select(0i, _e171, (_e171 > 0i)))];
let _e177 = local_9;
let _e178 = local_11;
let _e180 = local_10;
let _e181 = ((_e177 + _e178) + _e180);
let _e183 = select(_e119, _e181, (_e181 < _e119));
let _e188 = global_3.member[bitcast<u32>(select(0i, _e183, (_e183 > 0i)))];
let _e189 = local_9;
let _e190 = local_11;
let _e193 = local_10;
let _e194 = ((_e189 + (2i * _e190)) + _e193);
let _e196 = select(_e119, _e194, (_e194 < _e119));
let _e201 = global_3.member[bitcast<u32>(select(0i, _e196, (_e196 > 0i)))];
let _e202 = local_9;
let _e203 = local_11;
let _e206 = local_10;
let _e207 = ((_e202 + (3i * _e203)) + _e206);
let _e209 = select(_e119, _e207, (_e207 < _e119));
let _e214 = global_3.member[bitcast<u32>(select(0i, _e209, (_e209 > 0i)))];
let _e215 = local_9;
let _e216 = local_11;
let _e219 = local_10;
let _e220 = ((_e215 + (4i * _e216)) + _e219);
let _e222 = select(_e119, _e220, (_e220 < _e119));
let _e227 = global_3.member[bitcast<u32>(select(0i, _e222, (_e222 > 0i)))];
let _e228 = local_9;
let _e229 = local_11;
let _e232 = local_10;
let _e233 = ((_e228 + (5i * _e229)) + _e232);
let _e235 = select(_e119, _e233, (_e233 < _e119));
let _e240 = global_3.member[bitcast<u32>(select(0i, _e235, (_e235 > 0i)))];
let _e241 = local_9;
let _e242 = local_11;
let _e245 = local_10;
let _e246 = ((_e241 + (6i * _e242)) + _e245);
let _e248 = select(_e119, _e246, (_e246 < _e119));
let _e253 = global_3.member[bitcast<u32>(select(0i, _e248, (_e248 > 0i)))];
let _e254 = local_9;
let _e255 = local_11;
let _e258 = local_10;
let _e259 = ((_e254 + (7i * _e255)) + _e258);
let _e261 = select(_e119, _e259, (_e259 < _e119));
let _e266 = global_3.member[bitcast<u32>(select(0i, _e261, (_e261 > 0i)))];
let _e267 = local_9;
let _e268 = local_11;
let _e271 = local_10;
let _e272 = ((_e267 + (8i * _e268)) + _e271);
let _e274 = select(_e119, _e272, (_e272 < _e119));
let _e279 = global_3.member[bitcast<u32>(select(0i, _e274, (_e274 > 0i)))];
let _e280 = local_9;
let _e281 = local_11;
let _e284 = local_10;
let _e285 = ((_e280 + (9i * _e281)) + _e284);
let _e287 = select(_e119, _e285, (_e285 < _e119));
let _e292 = global_3.member[bitcast<u32>(select(0i, _e287, (_e287 > 0i)))];
let _e293 = local_9;
let _e294 = local_11;
let _e297 = local_10;
let _e298 = ((_e293 + (10i * _e294)) + _e297);
let _e300 = select(_e119, _e298, (_e298 < _e119));
let _e305 = global_3.member[bitcast<u32>(select(0i, _e300, (_e300 > 0i)))];
let _e306 = local_9;
let _e307 = local_11;
let _e310 = local_10;
let _e311 = ((_e306 + (11i * _e307)) + _e310);
let _e313 = select(_e119, _e311, (_e311 < _e119));
let _e318 = global_3.member[bitcast<u32>(select(0i, _e313, (_e313 > 0i)))];
let _e319 = local_9;
let _e320 = local_11;
let _e323 = local_10;
let _e324 = ((_e319 + (12i * _e320)) + _e323);
let _e326 = select(_e119, _e324, (_e324 < _e119));
let _e331 = global_3.member[bitcast<u32>(select(0i, _e326, (_e326 > 0i)))];
let _e332 = local_9;
let _e333 = local_11;
let _e336 = local_10;
let _e337 = ((_e332 + (13i * _e333)) + _e336);
let _e339 = select(_e119, _e337, (_e337 < _e119));
let _e344 = global_3.member[bitcast<u32>(select(0i, _e339, (_e339 > 0i)))];
let _e345 = local_9;
let _e346 = local_11;
let _e349 = local_10;
let _e350 = ((_e345 + (14i * _e346)) + _e349);
let _e352 = select(_e119, _e350, (_e350 < _e119));
let _e357 = global_3.member[bitcast<u32>(select(0i, _e352, (_e352 > 0i)))];
let _e358 = local_9;
let _e359 = local_11;
let _e362 = local_10;
let _e363 = ((_e358 + (15i * _e359)) + _e362);
let _e365 = select(_e119, _e363, (_e363 < _e119));
let _e370 = global_3.member[bitcast<u32>(select(0i, _e365, (_e365 > 0i)))];
let _e371 = local_9;
let _e372 = local_11;
let _e375 = local_10;
let _e376 = ((_e371 + (16i * _e372)) + _e375);
let _e378 = select(_e119, _e376, (_e376 < _e119));
let _e383 = global_3.member[bitcast<u32>(select(0i, _e378, (_e378 > 0i)))];
let _e384 = local_9;
let _e385 = local_11;
let _e388 = local_10;
let _e389 = ((_e384 + (17i * _e385)) + _e388);
let _e391 = select(_e119, _e389, (_e389 < _e119));
let _e396 = global_3.member[bitcast<u32>(select(0i, _e391, (_e391 > 0i)))];
let _e397 = local_9;
let _e398 = local_11;
let _e401 = local_10;
let _e402 = ((_e397 + (18i * _e398)) + _e401);
let _e404 = select(_e119, _e402, (_e402 < _e119));
let _e409 = global_3.member[bitcast<u32>(select(0i, _e404, (_e404 > 0i)))];
let _e410 = local_9;
let _e411 = local_11;
let _e414 = local_10;
let _e415 = ((_e410 + (19i * _e411)) + _e414);
let _e417 = select(_e119, _e415, (_e415 < _e119));
let _e422 = global_3.member[bitcast<u32>(select(0i, _e417, (_e417 > 0i)))];
let _e423 = local_9;
let _e424 = local_11;
let _e427 = local_10;
let _e428 = ((_e423 + (20i * _e424)) + _e427);
let _e430 = select(_e119, _e428, (_e428 < _e119));
let _e435 = global_3.member[bitcast<u32>(select(0i, _e430, (_e430 > 0i)))];
let _e436 = local_9;
let _e437 = local_11;
let _e440 = local_10;
let _e441 = ((_e436 + (23i * _e437)) + _e440);
let _e443 = select(_e119, _e441, (_e441 < _e119));
let _e448 = global_3.member[bitcast<u32>(select(0i, _e443, (_e443 > 0i)))];
local_6 = 0i;
local_7 = _e166;
local_8 = _e164;
let _e451 = local_6;
let _e452 = local_8;
let _e455 = local_7;
let _e456 = ((_e451 + (18i * _e452)) + _e455);
let _e458 = select(_e119, _e456, (_e456 < _e119));
let _e463 = global_3.member[bitcast<u32>(select(0i, _e458, (_e458 > 0i)))];
let _e464 = local_6;
let _e465 = local_8;
let _e468 = local_7;
let _e469 = ((_e464 + (19i * _e465)) + _e468);
let _e471 = select(_e119, _e469, (_e469 < _e119));
let _e476 = global_3.member[bitcast<u32>(select(0i, _e471, (_e471 > 0i)))];
let _e477 = local_6;
let _e478 = local_8;
let _e481 = local_7;
let _e482 = ((_e477 + (20i * _e478)) + _e481);
let _e484 = select(_e119, _e482, (_e482 < _e119));
let _e489 = global_3.member[bitcast<u32>(select(0i, _e484, (_e484 > 0i)))];
let _e491 = ((_e463 + _e476) + _e489);
let _e497 = global_1.member.member_6;
let _e501 = (_e176 - _e497.member);
let _e502 = (_e188 - _e497.member_1);
let _e503 = (_e201 - _e497.member_2);
let _e506 = ((_e502 * _e240) - (_e503 * _e227));
let _e509 = ((_e503 * _e214) - (_e501 * _e240));
let _e512 = ((_e501 * _e227) - (_e502 * _e214));
let _e515 = global_1.member.member_3;
let _e521 = global_1.member.member_4;
let _e527 = global_1.member.member_5;
let _e534 = global_1.member.member_2.member_3;
let _e535 = (_e534 != 0u);
let _e538 = ((_e527.member_1 * _e515.member_2) - (_e527.member_2 * _e515.member_1));
let _e541 = ((_e527.member_2 * _e515.member) - (_e527.member * _e515.member_2));
let _e544 = ((_e527.member * _e515.member_1) - (_e527.member_1 * _e515.member));
let _e556 = select((((_e515.member * _e506) + (_e515.member_1 * _e509)) + (_e515.member_2 * _e512)), -((((_e538 * _e214) + (_e541 * _e227)) + (_e544 * _e240))), _e535);
let _e559 = ((_e527.member_1 * _e521.member_2) - (_e527.member_2 * _e521.member_1));
let _e562 = ((_e527.member_2 * _e521.member) - (_e527.member * _e521.member_2));
let _e565 = ((_e527.member * _e521.member_1) - (_e527.member_1 * _e521.member));
let _e577 = select((((_e521.member * _e506) + (_e521.member_1 * _e509)) + (_e521.member_2 * _e512)), -((((_e559 * _e214) + (_e562 * _e227)) + (_e565 * _e240))), _e535);
let _e586 = global_1.member.member_1.member;
let _e587 = bitcast<i32>(_e586);
let _e588 = f32(_e587);
let _e592 = global_1.member.member_1.member_1;
let _e593 = bitcast<i32>(_e592);
let _e594 = f32(_e593);
let _e598 = global_1.member.member_2.member;
let _e602 = global_1.member.member_2.member_1;
let _e604 = ((2f * _e598) / _e588);
let _e605 = (_e556 * _e604);
let _e607 = ((-2f * _e602) / _e594);
let _e608 = (_e577 * _e607);
let _e610 = ((_e598 / _e588) - _e598);
let _e614 = (_e602 - (_e602 / _e594));
let _e616 = (((((_e527.member * _e506) + (_e527.member_1 * _e509)) + (_e527.member_2 * _e512)) + (_e556 * _e610)) + (_e577 * _e614));
let _e635 = (((_e266 * _e240) - (_e279 * _e227)) + ((_e502 * _e357) - (_e503 * _e344)));
let _e636 = (((_e279 * _e214) - (_e253 * _e240)) + ((_e503 * _e331) - (_e501 * _e357)));
let _e637 = (((_e253 * _e227) - (_e266 * _e214)) + ((_e501 * _e344) - (_e502 * _e331)));
let _e649 = select((((_e515.member * _e635) + (_e515.member_1 * _e636)) + (_e515.member_2 * _e637)), -((((_e538 * _e331) + (_e541 * _e344)) + (_e544 * _e357))), _e535);
let _e661 = select((((_e521.member * _e635) + (_e521.member_1 * _e636)) + (_e521.member_2 * _e637)), -((((_e559 * _e331) + (_e562 * _e344)) + (_e565 * _e357))), _e535);
let _e667 = (_e649 * _e604);
let _e668 = (_e661 * _e607);
let _e672 = (((((_e527.member * _e635) + (_e527.member_1 * _e636)) + (_e527.member_2 * _e637)) + (_e649 * _e610)) + (_e661 * _e614));
let _e691 = (((_e305 * _e240) - (_e318 * _e227)) + ((_e502 * _e396) - (_e503 * _e383)));
let _e692 = (((_e318 * _e214) - (_e292 * _e240)) + ((_e503 * _e370) - (_e501 * _e396)));
let _e693 = (((_e292 * _e227) - (_e305 * _e214)) + ((_e501 * _e383) - (_e502 * _e370)));
let _e705 = select((((_e515.member * _e691) + (_e515.member_1 * _e692)) + (_e515.member_2 * _e693)), -((((_e538 * _e370) + (_e541 * _e383)) + (_e544 * _e396))), _e535);
let _e717 = select((((_e521.member * _e691) + (_e521.member_1 * _e692)) + (_e521.member_2 * _e693)), -((((_e559 * _e370) + (_e562 * _e383)) + (_e565 * _e396))), _e535);
let _e723 = (_e705 * _e604);
let _e724 = (_e717 * _e607);
let _e728 = (((((_e527.member * _e691) + (_e527.member_1 * _e692)) + (_e527.member_2 * _e693)) + (_e705 * _e610)) + (_e717 * _e614));
let _e735 = (bitcast<f32>((bitcast<u32>(_e605) & 2147483647u)) > bitcast<f32>((bitcast<u32>(_e608) & 2147483647u)));
let _e736 = select(_e605, _e608, _e735);
let _e737 = select(_e608, _e605, _e735);
let _e738 = select(_e667, _e668, _e735);
let _e739 = select(_e668, _e667, _e735);
let _e740 = type_5(_e738, _e739, _e672);
let _e741 = select(_e723, _e724, _e735);
let _e742 = select(_e724, _e723, _e735);
let _e743 = type_5(_e741, _e742, _e728);
let _e746 = bitcast<f32>((bitcast<u32>(_e737) & 2147483647u));
let _e752 = ((((_e527.member * _e501) + (_e527.member_1 * _e502)) + (_e527.member_2 * _e503)) - 1e-3f);
let _e757 = (((_e527.member * _e214) + (_e527.member_1 * _e227)) + (_e527.member_2 * _e240));
if (_e534 == 0u) {
let _e760 = (_e757 == 0f);
let _e762 = (-(_e752) / select(_e757, 1e-30f, _e760));
phi_2152_ = type_26(select(0f, select(0f, _e762, (_e762 > 0f)), (_e757 > 0f)), select(select(_e448, select(_e448, _e762, (_e762 < _e448)), (_e757 < 0f)), -1f, (_e760 && (_e752 < 0f))));
} else {
phi_2152_ = type_26(0f, _e448);
}
let _e777 = phi_2152_;
let _e786 = ((_e176 + (_e214 * _e777.member)) - _e497.member);
let _e787 = ((_e188 + (_e227 * _e777.member)) - _e497.member_1);
let _e788 = ((_e201 + (_e240 * _e777.member)) - _e497.member_2);
let _e793 = (((_e527.member * _e786) + (_e527.member_1 * _e787)) + (_e527.member_2 * _e788));
let _e797 = select((1f / select(1e-3f, _e793, (_e793 > 1e-3f))), 1f, _e535);
let _e806 = (0.5f * _e588);
let _e808 = ((((((((_e515.member * _e786) + (_e515.member_1 * _e787)) + (_e515.member_2 * _e788)) * _e797) / _e598) + 1f) * _e806) - 0.5f);
let _e817 = (0.5f * _e594);
let _e819 = (((1f - (((((_e521.member * _e786) + (_e521.member_1 * _e787)) + (_e521.member_2 * _e788)) * _e797) / _e602)) * _e817) - 0.5f);
let _e820 = -(1e6f);
let _e822 = select(_e820, _e808, (_e808 > _e820));
let _e826 = select(_e820, _e819, (_e819 > _e820));
let _e829 = select(select(1e6f, _e822, (_e822 < 1e6f)), select(1e6f, _e826, (_e826 < 1e6f)), _e735);
let _e836 = ((_e176 + (_e214 * _e777.member_1)) - _e497.member);
let _e837 = ((_e188 + (_e227 * _e777.member_1)) - _e497.member_1);
let _e838 = ((_e201 + (_e240 * _e777.member_1)) - _e497.member_2);
let _e843 = (((_e527.member * _e836) + (_e527.member_1 * _e837)) + (_e527.member_2 * _e838));
let _e847 = select((1f / select(1e-3f, _e843, (_e843 > 1e-3f))), 1f, _e535);
let _e857 = ((((((((_e515.member * _e836) + (_e515.member_1 * _e837)) + (_e515.member_2 * _e838)) * _e847) / _e598) + 1f) * _e806) - 0.5f);
let _e867 = (((1f - (((((_e521.member * _e836) + (_e521.member_1 * _e837)) + (_e521.member_2 * _e838)) * _e847) / _e602)) * _e817) - 0.5f);
let _e869 = select(_e820, _e857, (_e857 > _e820));
let _e873 = select(_e820, _e867, (_e867 > _e820));
let _e876 = select(select(1e6f, _e869, (_e869 < 1e6f)), select(1e6f, _e873, (_e873 < 1e6f)), _e735);
if _e735 {
phi_2409_ = type_27(_e593, _e587);
} else {
phi_2409_ = type_27(_e587, _e593);
}
let _e880 = phi_2409_;
let _e884 = f32((_e880.member - 1i));
let _e886 = f32((_e880.member_1 - 1i));
let _e888 = select(_e876, _e829, (_e829 < _e876));
let _e890 = select(0f, _e888, (_e888 > 0f));
let _e892 = select(_e876, _e829, (_e829 > _e876));
let _e894 = select(_e884, _e892, (_e892 < _e884));
let _e898 = (-(((_e736 * _e890) + _e616)) / _e737);
let _e916 = (0.5f * 1f);
let _e917 = (((0.5f * (bitcast<f32>((bitcast<u32>(((_e738 * _e890) + ((_e739 * _e898) + _e672))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e741 * _e890) + ((_e742 * _e898) + _e728))) & 2147483647u)))) / _e746) + _e916);
let _e921 = (-(((_e736 * _e894) + _e616)) / _e737);
let _e939 = (((0.5f * (bitcast<f32>((bitcast<u32>(((_e738 * _e894) + ((_e739 * _e921) + _e672))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e741 * _e894) + ((_e742 * _e921) + _e728))) & 2147483647u)))) / _e746) + _e916);
let _e941 = select(_e939, _e917, (_e917 > _e939));
let _e943 = select(_e886, _e941, (_e941 < _e886));
let _e945 = (-(_e736) / _e737);
let _e950 = select(_e945, 1e-6f, (bitcast<f32>((bitcast<u32>(_e945) & 2147483647u)) < 1e-6f));
let _e952 = (-(_e616) / _e737);
let _e955 = ((-(_e943) - _e952) / _e950);
let _e958 = (((_e886 + _e943) - _e952) / _e950);
let _e961 = select(_e958, _e955, (_e955 < _e958));
let _e963 = select(_e961, _e890, (_e890 > _e961));
let _e965 = select(_e958, _e955, (_e955 > _e958));
let _e969 = select((_e890 - 1f), select(_e965, _e894, (_e894 < _e965)), (_e777.member_1 > _e777.member));
if ((_e746 > 0f) && (_e963 <= _e969)) {
phi_2543_ = 0i;
phi_2546_ = false;
loop {
let _e974 = phi_2543_;
let _e976 = phi_2546_;
local_16 = _e976;
let _e977 = (_e974 < 4i);
if _e977 {
let _e978 = (_e974 < 2i);
let _e981 = (1i - (2i * (_e974 & 1i)));
if _e978 {
phi_2563_ = _e163;
phi_2564_ = (_e162 + _e981);
} else {
phi_2563_ = (_e163 + _e981);
phi_2564_ = _e162;
}
let _e985 = phi_2563_;
let _e987 = phi_2564_;
let _e996 = ((_e985 * _e160) + _e987);
if ((((_e987 >= 0i) && (_e987 < _e160)) && (_e985 >= 0i)) && (_e985 < _e161)) {
local_3 = _e111;
local_4 = _e996;
local_5 = _e164;
let _e997 = local_3;
let _e998 = local_5;
let _e1001 = local_4;
let _e1002 = ((_e997 + (18i * _e998)) + _e1001);
let _e1004 = select(_e119, _e1002, (_e1002 < _e119));
let _e1009 = global_3.member[bitcast<u32>(select(0i, _e1004, (_e1004 > 0i)))];
let _e1010 = local_3;
let _e1011 = local_5;
let _e1014 = local_4;
let _e1015 = ((_e1010 + (19i * _e1011)) + _e1014);
let _e1017 = select(_e119, _e1015, (_e1015 < _e119));
let _e1022 = global_3.member[bitcast<u32>(select(0i, _e1017, (_e1017 > 0i)))];
let _e1024 = local_3;
let _e1025 = local_5;
let _e1028 = local_4;
let _e1029 = ((_e1024 + (20i * _e1025)) + _e1028);
let _e1031 = select(_e119, _e1029, (_e1029 < _e119));
let _e1036 = global_3.member[bitcast<u32>(select(0i, _e1031, (_e1031 > 0i)))];
if (((_e1009 + _e1022) + _e1036) > 0f) {
local = _e111;
local_1 = _e996;
local_2 = _e164;
let _e1039 = local;
let _e1040 = local_1;
let _e1041 = (_e1039 + _e1040);
let _e1043 = select(_e119, _e1041, (_e1041 < _e119));
let _e1048 = global_3.member[bitcast<u32>(select(0i, _e1043, (_e1043 > 0i)))];
let _e1049 = local;
let _e1050 = local_2;
let _e1052 = local_1;
let _e1053 = ((_e1049 + _e1050) + _e1052);
let _e1055 = select(_e119, _e1053, (_e1053 < _e119));
let _e1060 = global_3.member[bitcast<u32>(select(0i, _e1055, (_e1055 > 0i)))];
let _e1061 = local;
let _e1062 = local_2;
let _e1065 = local_1;
let _e1066 = ((_e1061 + (2i * _e1062)) + _e1065);
let _e1068 = select(_e119, _e1066, (_e1066 < _e119));
let _e1073 = global_3.member[bitcast<u32>(select(0i, _e1068, (_e1068 > 0i)))];
let _e1074 = local;
let _e1075 = local_2;
let _e1078 = local_1;
let _e1079 = ((_e1074 + (3i * _e1075)) + _e1078);
let _e1081 = select(_e119, _e1079, (_e1079 < _e119));
let _e1086 = global_3.member[bitcast<u32>(select(0i, _e1081, (_e1081 > 0i)))];
let _e1087 = local;
let _e1088 = local_2;
let _e1091 = local_1;
let _e1092 = ((_e1087 + (4i * _e1088)) + _e1091);
let _e1094 = select(_e119, _e1092, (_e1092 < _e119));
let _e1099 = global_3.member[bitcast<u32>(select(0i, _e1094, (_e1094 > 0i)))];
let _e1100 = local;
let _e1101 = local_2;
let _e1104 = local_1;
let _e1105 = ((_e1100 + (5i * _e1101)) + _e1104);
let _e1107 = select(_e119, _e1105, (_e1105 < _e119));
let _e1112 = global_3.member[bitcast<u32>(select(0i, _e1107, (_e1107 > 0i)))];
let _e1113 = local;
let _e1114 = local_2;
let _e1117 = local_1;
let _e1118 = ((_e1113 + (6i * _e1114)) + _e1117);
let _e1120 = select(_e119, _e1118, (_e1118 < _e119));
let _e1125 = global_3.member[bitcast<u32>(select(0i, _e1120, (_e1120 > 0i)))];
let _e1126 = local;
let _e1127 = local_2;
let _e1130 = local_1;
let _e1131 = ((_e1126 + (7i * _e1127)) + _e1130);
let _e1133 = select(_e119, _e1131, (_e1131 < _e119));
let _e1138 = global_3.member[bitcast<u32>(select(0i, _e1133, (_e1133 > 0i)))];
let _e1139 = local;
let _e1140 = local_2;
let _e1143 = local_1;
let _e1144 = ((_e1139 + (8i * _e1140)) + _e1143);
let _e1146 = select(_e119, _e1144, (_e1144 < _e119));
let _e1151 = global_3.member[bitcast<u32>(select(0i, _e1146, (_e1146 > 0i)))];
let _e1152 = local;
let _e1153 = local_2;
let _e1156 = local_1;
let _e1157 = ((_e1152 + (9i * _e1153)) + _e1156);
let _e1159 = select(_e119, _e1157, (_e1157 < _e119));
let _e1164 = global_3.member[bitcast<u32>(select(0i, _e1159, (_e1159 > 0i)))];
let _e1165 = local;
let _e1166 = local_2;
let _e1169 = local_1;
let _e1170 = ((_e1165 + (10i * _e1166)) + _e1169);
let _e1172 = select(_e119, _e1170, (_e1170 < _e119));
let _e1177 = global_3.member[bitcast<u32>(select(0i, _e1172, (_e1172 > 0i)))];
let _e1178 = local;
let _e1179 = local_2;
let _e1182 = local_1;
let _e1183 = ((_e1178 + (11i * _e1179)) + _e1182);
let _e1185 = select(_e119, _e1183, (_e1183 < _e119));
let _e1190 = global_3.member[bitcast<u32>(select(0i, _e1185, (_e1185 > 0i)))];
let _e1191 = local;
let _e1192 = local_2;
let _e1195 = local_1;
let _e1196 = ((_e1191 + (12i * _e1192)) + _e1195);
let _e1198 = select(_e119, _e1196, (_e1196 < _e119));
let _e1203 = global_3.member[bitcast<u32>(select(0i, _e1198, (_e1198 > 0i)))];
let _e1204 = local;
let _e1205 = local_2;
let _e1208 = local_1;
let _e1209 = ((_e1204 + (13i * _e1205)) + _e1208);
let _e1211 = select(_e119, _e1209, (_e1209 < _e119));
let _e1216 = global_3.member[bitcast<u32>(select(0i, _e1211, (_e1211 > 0i)))];
let _e1217 = local;
let _e1218 = local_2;
let _e1221 = local_1;
let _e1222 = ((_e1217 + (14i * _e1218)) + _e1221);
let _e1224 = select(_e119, _e1222, (_e1222 < _e119));
let _e1229 = global_3.member[bitcast<u32>(select(0i, _e1224, (_e1224 > 0i)))];
let _e1230 = local;
let _e1231 = local_2;
let _e1234 = local_1;
let _e1235 = ((_e1230 + (15i * _e1231)) + _e1234);
let _e1237 = select(_e119, _e1235, (_e1235 < _e119));
let _e1242 = global_3.member[bitcast<u32>(select(0i, _e1237, (_e1237 > 0i)))];
let _e1243 = local;
let _e1244 = local_2;
let _e1247 = local_1;
let _e1248 = ((_e1243 + (16i * _e1244)) + _e1247);
let _e1250 = select(_e119, _e1248, (_e1248 < _e119));
let _e1255 = global_3.member[bitcast<u32>(select(0i, _e1250, (_e1250 > 0i)))];
let _e1256 = local;
let _e1257 = local_2;
let _e1260 = local_1;
let _e1261 = ((_e1256 + (17i * _e1257)) + _e1260);
let _e1263 = select(_e119, _e1261, (_e1261 < _e119));
let _e1268 = global_3.member[bitcast<u32>(select(0i, _e1263, (_e1263 > 0i)))];
let _e1269 = (_e1048 - _e497.member);
let _e1270 = (_e1060 - _e497.member_1);
let _e1271 = (_e1073 - _e497.member_2);
let _e1274 = ((_e1270 * _e1112) - (_e1271 * _e1099));
let _e1277 = ((_e1271 * _e1086) - (_e1269 * _e1112));
let _e1280 = ((_e1269 * _e1099) - (_e1270 * _e1086));
let _e1292 = select((((_e515.member * _e1274) + (_e515.member_1 * _e1277)) + (_e515.member_2 * _e1280)), -((((_e538 * _e1086) + (_e541 * _e1099)) + (_e544 * _e1112))), _e535);
let _e1304 = select((((_e521.member * _e1274) + (_e521.member_1 * _e1277)) + (_e521.member_2 * _e1280)), -((((_e559 * _e1086) + (_e562 * _e1099)) + (_e565 * _e1112))), _e535);
let _e1310 = (_e1292 * _e604);
let _e1311 = (_e1304 * _e607);
let _e1334 = (((_e1138 * _e1112) - (_e1151 * _e1099)) + ((_e1270 * _e1229) - (_e1271 * _e1216)));
let _e1335 = (((_e1151 * _e1086) - (_e1125 * _e1112)) + ((_e1271 * _e1203) - (_e1269 * _e1229)));
let _e1336 = (((_e1125 * _e1099) - (_e1138 * _e1086)) + ((_e1269 * _e1216) - (_e1270 * _e1203)));
let _e1348 = select((((_e515.member * _e1334) + (_e515.member_1 * _e1335)) + (_e515.member_2 * _e1336)), -((((_e538 * _e1203) + (_e541 * _e1216)) + (_e544 * _e1229))), _e535);
let _e1360 = select((((_e521.member * _e1334) + (_e521.member_1 * _e1335)) + (_e521.member_2 * _e1336)), -((((_e559 * _e1203) + (_e562 * _e1216)) + (_e565 * _e1229))), _e535);
let _e1366 = (_e1348 * _e604);
let _e1367 = (_e1360 * _e607);
let _e1390 = (((_e1177 * _e1112) - (_e1190 * _e1099)) + ((_e1270 * _e1268) - (_e1271 * _e1255)));
let _e1391 = (((_e1190 * _e1086) - (_e1164 * _e1112)) + ((_e1271 * _e1242) - (_e1269 * _e1268)));
let _e1392 = (((_e1164 * _e1099) - (_e1177 * _e1086)) + ((_e1269 * _e1255) - (_e1270 * _e1242)));
let _e1404 = select((((_e515.member * _e1390) + (_e515.member_1 * _e1391)) + (_e515.member_2 * _e1392)), -((((_e538 * _e1242) + (_e541 * _e1255)) + (_e544 * _e1268))), _e535);
let _e1416 = select((((_e521.member * _e1390) + (_e521.member_1 * _e1391)) + (_e521.member_2 * _e1392)), -((((_e559 * _e1242) + (_e562 * _e1255)) + (_e565 * _e1268))), _e535);
let _e1422 = (_e1404 * _e604);
let _e1423 = (_e1416 * _e607);
let _e1432 = type_5(select(_e1366, _e1367, _e735), select(_e1367, _e1366, _e735), (((((_e527.member * _e1334) + (_e527.member_1 * _e1335)) + (_e527.member_2 * _e1336)) + (_e1348 * _e610)) + (_e1360 * _e614)));
let _e1435 = type_5(select(_e1422, _e1423, _e735), select(_e1423, _e1422, _e735), (((((_e527.member * _e1390) + (_e527.member_1 * _e1391)) + (_e527.member_2 * _e1392)) + (_e1404 * _e610)) + (_e1416 * _e614)));
if _e978 {
phi_3773_ = type_25(_e1432, _e1435);
phi_3774_ = type_25(_e740, _e743);
} else {
phi_3773_ = type_25(_e1435, _e1432);
phi_3774_ = type_25(_e743, _e740);
}
let _e1441 = phi_3773_;
let _e1443 = phi_3774_;
phi_3777_ = 0i;
phi_3780_ = _e976;
loop {
let _e1446 = phi_3777_;
let _e1448 = phi_3780_;
local_15 = _e1448;
let _e1449 = (_e1446 < 5i);
if _e1449 {
let _e1454 = (_e963 + ((_e969 - _e963) * (f32(_e1446) / 4f)));
let _e1458 = (-(((_e736 * _e1454) + _e616)) / _e737);
let _e1468 = ((_e1443.member.member * _e1454) + ((_e1443.member.member_1 * _e1458) + _e1443.member.member_2));
let _e1478 = ((_e1443.member_1.member * _e1454) + ((_e1443.member_1.member_1 * _e1458) + _e1443.member_1.member_2));
let _e1498 = ((_e1441.member_1.member * _e1454) + ((_e1441.member_1.member_1 * _e1458) + _e1441.member_1.member_2));
let _e1507 = bitcast<f32>((bitcast<u32>((((select(_e1310, _e1311, _e735) * _e1454) + ((select(_e1311, _e1310, _e735) * _e1458) + (((((_e527.member * _e1274) + (_e527.member_1 * _e1277)) + (_e527.member_2 * _e1280)) + (_e1292 * _e610)) + (_e1304 * _e614)))) - (f32(_e981) * _e1468))) & 2147483647u));
let _e1511 = bitcast<f32>((bitcast<u32>((_e1498 - _e1478)) & 2147483647u));
let _e1518 = (bitcast<f32>((bitcast<u32>(_e1468) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1478) & 2147483647u)));
let _e1528 = select(_e1511, _e1507, (_e1507 > _e1511));
phi_3778_ = (_e1446 + 1i);
phi_3781_ = (_e1448 || (((_e1507 <= (2f * (((_e1518 + bitcast<f32>((bitcast<u32>(((_e1441.member.member * _e1454) + ((_e1441.member.member_1 * _e1458) + _e1441.member.member_2))) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e1498) & 2147483647u))) + _e746))) && (_e1528 > (0.5f * _e746))) && (((((_e409 + _e422) + _e435) / select(1.1754944e-38f, _e491, (_e491 > 1.1754944e-38f))) * _e1528) > (0.1f * select(_e746, _e1518, (_e1518 > _e746))))));
} else {
phi_3778_ = i32();
phi_3781_ = bool();
}
let _e1544 = phi_3778_;
let _e1546 = phi_3781_;
continue;
continuing {
phi_3777_ = _e1544;
phi_3780_ = _e1546;
break if !(_e1449);
}
}
let _e1577 = local_15;
phi_3876_ = _e1577;
} else {
phi_3876_ = _e976;
}
let _e1549 = phi_3876_;
phi_3877_ = _e1549;
} else {
phi_3877_ = _e976;
}
let _e1551 = phi_3877_;
phi_2544_ = (_e974 + 1i);
phi_2547_ = _e1551;
} else {
phi_2544_ = i32();
phi_2547_ = bool();
}
let _e1554 = phi_2544_;
let _e1556 = phi_2547_;
continue;
continuing {
phi_2543_ = _e1554;
phi_2546_ = _e1556;
break if !(_e977);
}
}
let _e1583 = local_16;
phi_3879_ = _e1583;
} else {
phi_3879_ = false;
}
let _e1559 = phi_3879_;
global_2.member[_e77] = select(_e88, 1f, _e1559);
}
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
