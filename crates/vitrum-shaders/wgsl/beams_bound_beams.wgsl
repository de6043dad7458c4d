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
member: vec3<f32>,
member_1: vec3<f32>,
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
var phi_153_: u32;
var phi_154_: u32;
var local_6: u32;
var local_7: u32;
var phi_175_: u32;
var phi_183_: u32;
var phi_184_: u32;
var local_8: u32;
var local_9: u32;
var phi_212_: u32;
var phi_213_: u32;
var local_10: u32;
var local_11: u32;
var local_12: u32;
var local_13: u32;
var phi_277_: u32;
var phi_280_: type_25;
var phi_282_: type_25;
var phi_284_: type_25;
var phi_286_: type_25;
var phi_295_: u32;
var phi_296_: u32;
var local_14: u32;
var local_15: u32;
var phi_313_: u32;
var phi_314_: u32;
var local_16: u32;
var local_17: u32;
var phi_336_: u32;
var phi_337_: u32;
var phi_349_: u32;
var phi_350_: u32;
var local_18: u32;
var local_19: u32;
var local_20: u32;
var phi_377_: u32;
var phi_380_: type_25;
var phi_382_: type_25;
var phi_384_: type_25;
var phi_386_: type_25;
var phi_1524_: type_25;
var phi_1525_: type_25;
var phi_1526_: type_25;
var phi_1527_: type_25;
var phi_1528_: type_25;
var phi_378_: u32;
var phi_381_: type_25;
var phi_383_: type_25;
var phi_385_: type_25;
var phi_387_: type_25;
var phi_278_: u32;
var phi_281_: type_25;
var phi_283_: type_25;
var phi_285_: type_25;
var phi_287_: type_25;
var local_21: type_25;
var local_22: type_25;
var local_23: type_25;
var local_24: type_25;
var local_25: type_25;
var local_26: type_25;
var local_27: type_25;
var local_28: type_25;
var local_29: type_25;
var local_30: type_25;
var local_31: type_25;
var local_32: type_25;
let _e72 = global;
let _e78 = global_1.member.member;
if (_e72.x < _e78.member) {
if (_e72.y < _e78.member_1) {
let _e85 = (_e78.member * _e78.member_1);
let _e87 = ((_e72.y * _e78.member) + _e72.x);
let _e91 = global_1.member.member_11.member;
phi_153_ = 0u;
loop {
let _e93 = phi_153_;
local_6 = _e93;
local_7 = _e93;
let _e97 = ((1u << bitcast<u32>((_e93 & 31u))) < _e91);
if _e97 {
phi_154_ = (_e93 + 1u);
} else {
phi_154_ = u32();
}
let _e100 = phi_154_;
continue;
continuing {
phi_153_ = _e100;
break if !(_e97);
}
}
let _e103 = local_6;
let _e106 = local_7;
let _e111 = global_1.member.member.member;
let _e113 = ((_e72.y * _e111) + _e72.x);
phi_175_ = 0u;
loop {
let _e115 = phi_175_;
let _e117 = (_e115 + 1u);
phi_183_ = 0u;
local_12 = _e115;
local_13 = _e115;
loop {
let _e119 = phi_183_;
local_8 = _e119;
local_9 = _e119;
let _e123 = ((1u << bitcast<u32>((_e119 & 31u))) < _e91);
if _e123 {
phi_184_ = (_e119 + 1u);
} else {
phi_184_ = u32();
}
let _e126 = phi_184_;
continue;
continuing {
phi_183_ = _e126;
break if !(_e123);
}
}
let _e129 = local_8;
let _e135 = local_9;
let _e145 = ((_e115 < select(6u, _e106, (_e103 < 6u))) && (_e113 >= ((((1u << bitcast<u32>(((2u * _e129) & 31u))) - (1u << bitcast<u32>(((2u * (_e135 - _e117)) & 31u)))) / 3u) * 4u)));
continue;
continuing {
phi_175_ = select(u32(), _e117, _e145);
break if !(_e145);
}
}
phi_212_ = 0u;
loop {
let _e149 = phi_212_;
local_10 = _e149;
local_11 = _e149;
let _e153 = ((1u << bitcast<u32>((_e149 & 31u))) < _e91);
if _e153 {
phi_213_ = (_e149 + 1u);
} else {
phi_213_ = u32();
}
let _e156 = phi_213_;
continue;
continuing {
phi_212_ = _e156;
break if !(_e153);
}
}
let _e159 = local_10;
let _e165 = local_11;
let _e167 = local_12;
let _e176 = (_e113 - ((((1u << bitcast<u32>(((2u * _e159) & 31u))) - (1u << bitcast<u32>(((2u * (_e165 - _e167)) & 31u)))) / 3u) * 4u));
let _e177 = (_e176 & 1431655765u);
let _e181 = ((_e177 | (_e177 >> bitcast<u32>(1i))) & 858993459u);
let _e185 = ((_e181 | (_e181 >> bitcast<u32>(2i))) & 252645135u);
let _e189 = ((_e185 | (_e185 >> bitcast<u32>(4i))) & 16711935u);
let _e196 = ((_e176 >> bitcast<u32>(1i)) & 1431655765u);
let _e200 = ((_e196 | (_e196 >> bitcast<u32>(1i))) & 858993459u);
let _e204 = ((_e200 | (_e200 >> bitcast<u32>(2i))) & 252645135u);
let _e208 = ((_e204 | (_e204 >> bitcast<u32>(4i))) & 16711935u);
let _e214 = local_13;
let _e217 = (1u << bitcast<u32>((_e214 & 31u)));
let _e218 = (((_e189 | (_e189 >> bitcast<u32>(8i))) & 65535u) * _e217);
let _e219 = (((_e208 | (_e208 >> bitcast<u32>(8i))) & 65535u) * _e217);
let _e221 = bitcast<i32>((_e91 * _e91));
let _e225 = global_1.member.member_12.member_4;
let _e229 = global_1.member.member_12.member_6;
let _e231 = bitcast<i32>((_e225 * _e229));
phi_277_ = _e219;
phi_280_ = type_25(vec3<f32>(1e30f, 1e30f, 1e30f), vec3<f32>(-1e30f, -1e30f, -1e30f));
phi_282_ = type_25(vec3<f32>(1e30f, 1e30f, 1e30f), vec3<f32>(-1e30f, -1e30f, -1e30f));
phi_284_ = type_25(vec3<f32>(1e30f, 1e30f, 1e30f), vec3<f32>(-1e30f, -1e30f, -1e30f));
phi_286_ = type_25(vec3<f32>(1e30f, 1e30f, 1e30f), vec3<f32>(-1e30f, -1e30f, -1e30f));
loop {
let _e233 = phi_277_;
let _e235 = phi_280_;
let _e237 = phi_282_;
let _e239 = phi_284_;
let _e241 = phi_286_;
phi_295_ = 0u;
local_21 = _e241;
local_22 = _e241;
local_23 = _e239;
local_24 = _e239;
local_25 = _e237;
local_26 = _e237;
local_27 = _e235;
local_28 = _e235;
loop {
let _e247 = phi_295_;
local_14 = _e247;
local_15 = _e247;
let _e251 = ((1u << bitcast<u32>((_e247 & 31u))) < _e91);
if _e251 {
phi_296_ = (_e247 + 1u);
} else {
phi_296_ = u32();
}
let _e254 = phi_296_;
continue;
continuing {
phi_295_ = _e254;
break if !(_e251);
}
}
let _e257 = local_14;
let _e260 = local_15;
phi_313_ = 0u;
loop {
let _e263 = phi_313_;
local_16 = _e263;
local_17 = _e263;
let _e267 = ((1u << bitcast<u32>((_e263 & 31u))) < _e91);
if _e267 {
phi_314_ = (_e263 + 1u);
} else {
phi_314_ = u32();
}
let _e270 = phi_314_;
continue;
continuing {
phi_313_ = _e270;
break if !(_e267);
}
}
let _e273 = local_16;
let _e279 = local_17;
phi_336_ = 0u;
loop {
let _e289 = phi_336_;
local_20 = _e289;
let _e293 = ((1u << bitcast<u32>((_e289 & 31u))) < _e91);
if _e293 {
phi_337_ = (_e289 + 1u);
} else {
phi_337_ = u32();
}
let _e296 = phi_337_;
continue;
continuing {
phi_336_ = _e296;
break if !(_e293);
}
}
phi_349_ = 0u;
loop {
let _e299 = phi_349_;
local_18 = _e299;
local_19 = _e299;
let _e303 = ((1u << bitcast<u32>((_e299 & 31u))) < _e91);
if _e303 {
phi_350_ = (_e299 + 1u);
} else {
phi_350_ = u32();
}
let _e306 = phi_350_;
continue;
continuing {
phi_349_ = _e306;
break if !(_e303);
}
}
let _e309 = local_18;
let _e312 = local_19;
let _e315 = local_20;
let _e323 = (((_e233 < (_e219 + _e217)) && (_e233 < _e91)) && (_e113 < (((((1u << bitcast<u32>(((2u * _e273) & 31u))) - (1u << bitcast<u32>(((2u * (_e279 - select(6u, _e260, (_e257 < 6u)))) & 31u)))) / 3u) * 4u) + (1u << bitcast<u32>(((2u * (_e315 - select(6u, _e312, (_e309 < 6u)))) & 31u))))));
if _e323 {
phi_377_ = _e218;
phi_380_ = _e235;
phi_382_ = _e237;
phi_384_ = _e239;
phi_386_ = _e241;
loop {
let _e325 = phi_377_;
let _e327 = phi_380_;
let _e329 = phi_382_;
let _e331 = phi_384_;
let _e333 = phi_386_;
local_29 = _e327;
local_30 = _e329;
local_31 = _e331;
local_32 = _e333;
let _e337 = ((_e325 < (_e218 + _e217)) && (_e325 < _e91));
if _e337 {
let _e340 = bitcast<i32>(((_e233 * _e91) + _e325));
local_3 = _e231;
local_4 = _e340;
local_5 = _e221;
let _e341 = local_3;
let _e342 = local_5;
let _e345 = local_4;
let _e346 = ((_e341 + (18i * _e342)) + _e345);
let _e348 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e350 = select(_e348, _e346, (_e346 < _e348));
let _e355 = global_3.member[bitcast<u32>(select(0i, _e350, (_e350 > 0i)))];
let _e356 = local_3;
let _e357 = local_5;
let _e360 = local_4;
let _e361 = ((_e356 + (19i * _e357)) + _e360);
let _e363 = select(_e348, _e361, (_e361 < _e348));
let _e368 = global_3.member[bitcast<u32>(select(0i, _e363, (_e363 > 0i)))];
let _e370 = local_3;
let _e371 = local_5;
let _e374 = local_4;
let _e375 = ((_e370 + (20i * _e371)) + _e374);
let _e377 = select(_e348, _e375, (_e375 < _e348));
let _e382 = global_3.member[bitcast<u32>(select(0i, _e377, (_e377 > 0i)))];
if (((_e355 + _e368) + _e382) > 0f) {
local = _e231;
local_1 = _e340;
local_2 = _e221;
let _e385 = local;
let _e386 = local_1;
let _e387 = (_e385 + _e386);
let _e389 = select(_e348, _e387, (_e387 < _e348));
let _e394 = global_3.member[bitcast<u32>(select(0i, _e389, (_e389 > 0i)))];
let _e395 = local;
let _e396 = local_2;
let _e398 = local_1;
let _e399 = ((_e395 + _e396) + _e398);
let _e401 = select(_e348, _e399, (_e399 < _e348));
let _e406 = global_3.member[bitcast<u32>(select(0i, _e401, (_e401 > 0i)))];
let _e407 = local;
let _e408 = local_2;
let _e411 = local_1;
let _e412 = ((_e407 + (2i * _e408)) + _e411);
let _e414 = select(_e348, _e412, (_e412 < _e348));
let _e419 = global_3.member[bitcast<u32>(select(0i, _e414, (_e414 > 0i)))];
let _e420 = local;
let _e421 = local_2;
let _e424 = local_1;
let _e425 = ((_e420 + (3i * _e421)) + _e424);
let _e427 = select(_e348, _e425, (_e425 < _e348));
let _e432 = global_3.member[bitcast<u32>(select(0i, _e427, (_e427 > 0i)))];
let _e433 = local;
let _e434 = local_2;
let _e437 = local_1;
let _e438 = ((_e433 + (4i * _e434)) + _e437);
let _e440 = select(_e348, _e438, (_e438 < _e348));
let _e445 = global_3.member[bitcast<u32>(select(0i, _e440, (_e440 > 0i)))];
let _e446 = local;
let _e447 = local_2;
let _e450 = local_1;
let _e451 = ((_e446 + (5i * _e447)) + _e450);
let _e453 = select(_e348, _e451, (_e451 < _e348));
let _e458 = global_3.member[bitcast<u32>(select(0i, _e453, (_e453 > 0i)))];
let _e459 = local;
let _e460 = local_2;
let _e463 = local_1;
let _e464 = ((_e459 + (6i * _e460)) + _e463);
let _e466 = select(_e348, _e464, (_e464 < _e348));
let _e471 = global_3.member[bitcast<u32>(select(0i, _e466, (_e466 > 0i)))];
let _e472 = local;
let _e473 = local_2;
let _e476 = local_1;
let _e477 = ((_e472 + (7i * _e473)) + _e476);
let _e479 = select(_e348, _e477, (_e477 < _e348));
let _e484 = global_3.member[bitcast<u32>(select(0i, _e479, (_e479 > 0i)))];
let _e485 = local;
let _e486 = local_2;
let _e489 = local_1;
let _e490 = ((_e485 + (8i * _e486)) + _e489);
let _e492 = select(_e348, _e490, (_e490 < _e348));
let _e497 = global_3.member[bitcast<u32>(select(0i, _e492, (_e492 > 0i)))];
let _e498 = local;
let _e499 = local_2;
let _e502 = local_1;
let _e503 = ((_e498 + (9i * _e499)) + _e502);
let _e505 = select(_e348, _e503, (_e503 < _e348));
let _e510 = global_3.member[bitcast<u32>(select(0i, _e505, (_e505 > 0i)))];
let _e511 = local;
let _e512 = local_2;
let _e515 = local_1;
let _e516 = ((_e511 + (10i * _e512)) + _e515);
let _e518 = select(_e348, _e516, (_e516 < _e348));
let _e523 = global_3.member[bitcast<u32>(select(0i, _e518, (_e518 > 0i)))];
let _e524 = local;
let _e525 = local_2;
let _e528 = local_1;
let _e529 = ((_e524 + (11i * _e525)) + _e528);
let _e531 = select(_e348, _e529, (_e529 < _e348));
let _e536 = global_3.member[bitcast<u32>(select(0i, _e531, (_e531 > 0i)))];
let _e537 = local;
let _e538 = local_2;
let _e541 = local_1;
let _e542 = ((_e537 + (12i * _e538)) + _e541);
let _e544 = select(_e348, _e542, (_e542 < _e348));
let _e549 = global_3.member[bitcast<u32>(select(0i, _e544, (_e544 > 0i)))];
let _e550 = local;
let _e551 = local_2;
let _e554 = local_1;
let _e555 = ((_e550 + (13i * _e551)) + _e554);
let _e557 = select(_e348, _e555, (_e555 < _e348));
let _e562 = global_3.member[bitcast<u32>(select(0i, _e557, (_e557 > 0i)))];
let _e563 = local;
let _e564 = local_2;
let _e567 = local_1;
let _e568 = ((_e563 + (14i * _e564)) + _e567);
let _e570 = select(_e348, _e568, (_e568 < _e348));
let _e575 = global_3.member[bitcast<u32>(select(0i, _e570, (_e570 > 0i)))];
let _e576 = local;
let _e577 = local_2;
let _e580 = local_1;
let _e581 = ((_e576 + (15i * _e577)) + _e580);
let _e583 = select(_e348, _e581, (_e581 < _e348));
let _e588 = global_3.member[bitcast<u32>(select(0i, _e583, (_e583 > 0i)))];
let _e589 = local;
let _e590 = local_2;
let _e593 = local_1;
let _e594 = ((_e589 + (16i * _e590)) + _e593);
let _e596 = select(_e348, _e594, (_e594 < _e348));
let _e601 = global_3.member[bitcast<u32>(select(0i, _e596, (_e596 > 0i)))];
let _e602 = local;
let _e603 = local_2;
let _e606 = local_1;
let _e607 = ((_e602 + (17i * _e603)) + _e606);
let _e609 = select(_e348, _e607, (_e607 < _e348));
let _e614 = global_3.member[bitcast<u32>(select(0i, _e609, (_e609 > 0i)))];
let _e615 = local;
let _e616 = local_2;
let _e619 = local_1;
let _e620 = ((_e615 + (22i * _e616)) + _e619);
let _e622 = select(_e348, _e620, (_e620 < _e348));
let _e627 = global_3.member[bitcast<u32>(select(0i, _e622, (_e622 > 0i)))];
let _e628 = local;
let _e629 = local_2;
let _e632 = local_1;
let _e633 = ((_e628 + (23i * _e629)) + _e632);
let _e635 = select(_e348, _e633, (_e633 < _e348));
let _e640 = global_3.member[bitcast<u32>(select(0i, _e635, (_e635 > 0i)))];
let _e641 = local;
let _e642 = local_2;
let _e645 = local_1;
let _e646 = ((_e641 + (24i * _e642)) + _e645);
let _e648 = select(_e348, _e646, (_e646 < _e348));
let _e653 = global_3.member[bitcast<u32>(select(0i, _e648, (_e648 > 0i)))];
let _e687 = ((bitcast<f32>((bitcast<u32>((_e471 + (_e549 * 0f))) & 2147483647u)) + bitcast<f32>((bitcast<u32>((_e510 + (_e588 * 0f))) & 2147483647u))) * 0.5f);
let _e688 = ((bitcast<f32>((bitcast<u32>((_e484 + (_e562 * 0f))) & 2147483647u)) + bitcast<f32>((bitcast<u32>((_e523 + (_e601 * 0f))) & 2147483647u))) * 0.5f);
let _e689 = ((bitcast<f32>((bitcast<u32>((_e497 + (_e575 * 0f))) & 2147483647u)) + bitcast<f32>((bitcast<u32>((_e536 + (_e614 * 0f))) & 2147483647u))) * 0.5f);
let _e693 = (1f / (1f - select(0.5f, _e627, (_e627 < 0.5f))));
let _e694 = (_e687 * _e693);
let _e695 = (_e688 * _e693);
let _e696 = (_e689 * _e693);
let _e697 = (_e394 - _e694);
let _e698 = (_e406 - _e695);
let _e699 = (_e419 - _e696);
let _e700 = (_e394 + _e694);
let _e701 = (_e406 + _e695);
let _e702 = (_e419 + _e696);
let _e706 = select(_e697, _e333.member.x, (_e333.member.x < _e697));
let _e710 = select(_e698, _e333.member.y, (_e333.member.y < _e698));
let _e714 = select(_e699, _e333.member.z, (_e333.member.z < _e699));
let _e718 = select(_e700, _e333.member_1.x, (_e333.member_1.x > _e700));
let _e722 = select(_e701, _e333.member_1.y, (_e333.member_1.y > _e701));
let _e726 = select(_e702, _e333.member_1.z, (_e333.member_1.z > _e702));
let _e763 = (((bitcast<f32>((bitcast<u32>((_e471 + (_e549 * _e640))) & 2147483647u)) + bitcast<f32>((bitcast<u32>((_e510 + (_e588 * _e640))) & 2147483647u))) * 0.5f) * _e693);
let _e764 = (((bitcast<f32>((bitcast<u32>((_e484 + (_e562 * _e640))) & 2147483647u)) + bitcast<f32>((bitcast<u32>((_e523 + (_e601 * _e640))) & 2147483647u))) * 0.5f) * _e693);
let _e765 = (((bitcast<f32>((bitcast<u32>((_e497 + (_e575 * _e640))) & 2147483647u)) + bitcast<f32>((bitcast<u32>((_e536 + (_e614 * _e640))) & 2147483647u))) * 0.5f) * _e693);
let _e769 = (_e394 + (_e432 * _e640));
let _e770 = (_e406 + (_e445 * _e640));
let _e771 = (_e419 + (_e458 * _e640));
let _e772 = (_e769 - _e763);
let _e773 = (_e770 - _e764);
let _e774 = (_e771 - _e765);
let _e775 = (_e769 + _e763);
let _e776 = (_e770 + _e764);
let _e777 = (_e771 + _e765);
let _e793 = (_e394 - _e687);
let _e794 = (_e406 - _e688);
let _e795 = (_e419 - _e689);
let _e796 = (_e394 + _e687);
let _e797 = (_e406 + _e688);
let _e798 = (_e419 + _e689);
let _e847 = ((bitcast<f32>((bitcast<u32>(_e549) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e588) & 2147483647u))) * 0.5f);
let _e848 = ((bitcast<f32>((bitcast<u32>(_e562) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e601) & 2147483647u))) * 0.5f);
let _e849 = ((bitcast<f32>((bitcast<u32>(_e575) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e614) & 2147483647u))) * 0.5f);
let _e850 = (_e432 - _e847);
let _e851 = (_e445 - _e848);
let _e852 = (_e458 - _e849);
let _e853 = (_e432 + _e847);
let _e854 = (_e445 + _e848);
let _e855 = (_e458 + _e849);
if (_e653 < (0.5f * 1e30f)) {
let _e918 = ((bitcast<f32>((bitcast<u32>((_e471 + (_e549 * _e653))) & 2147483647u)) + bitcast<f32>((bitcast<u32>((_e510 + (_e588 * _e653))) & 2147483647u))) * 0.5f);
let _e919 = ((bitcast<f32>((bitcast<u32>((_e484 + (_e562 * _e653))) & 2147483647u)) + bitcast<f32>((bitcast<u32>((_e523 + (_e601 * _e653))) & 2147483647u))) * 0.5f);
let _e920 = ((bitcast<f32>((bitcast<u32>((_e497 + (_e575 * _e653))) & 2147483647u)) + bitcast<f32>((bitcast<u32>((_e536 + (_e614 * _e653))) & 2147483647u))) * 0.5f);
let _e931 = ((_e918 + _e919) + _e920);
let _e938 = (_e394 + (_e432 * _e653));
let _e939 = (_e406 + (_e445 * _e653));
let _e940 = (_e419 + (_e458 * _e653));
let _e941 = (_e918 + (bitcast<f32>((bitcast<u32>(_e432) & 2147483647u)) * _e931));
let _e942 = (_e919 + (bitcast<f32>((bitcast<u32>(_e445) & 2147483647u)) * _e931));
let _e943 = (_e920 + (bitcast<f32>((bitcast<u32>(_e458) & 2147483647u)) * _e931));
let _e944 = (_e938 - _e941);
let _e945 = (_e939 - _e942);
let _e946 = (_e940 - _e943);
let _e947 = (_e938 + _e941);
let _e948 = (_e939 + _e942);
let _e949 = (_e940 + _e943);
phi_1524_ = type_25(vec3<f32>(select(_e944, _e327.member.x, (_e327.member.x < _e944)), select(_e945, _e327.member.y, (_e327.member.y < _e945)), select(_e946, _e327.member.z, (_e327.member.z < _e946))), vec3<f32>(select(_e947, _e327.member_1.x, (_e327.member_1.x > _e947)), select(_e948, _e327.member_1.y, (_e327.member_1.y > _e948)), select(_e949, _e327.member_1.z, (_e327.member_1.z > _e949))));
} else {
phi_1524_ = _e327;
}
let _e978 = phi_1524_;
phi_1525_ = _e978;
phi_1526_ = type_25(vec3<f32>(select(_e850, _e329.member.x, (_e329.member.x < _e850)), select(_e851, _e329.member.y, (_e329.member.y < _e851)), select(_e852, _e329.member.z, (_e329.member.z < _e852))), vec3<f32>(select(_e853, _e329.member_1.x, (_e329.member_1.x > _e853)), select(_e854, _e329.member_1.y, (_e329.member_1.y > _e854)), select(_e855, _e329.member_1.z, (_e329.member_1.z > _e855))));
phi_1527_ = type_25(vec3<f32>(select(_e793, _e331.member.x, (_e331.member.x < _e793)), select(_e794, _e331.member.y, (_e331.member.y < _e794)), select(_e795, _e331.member.z, (_e331.member.z < _e795))), vec3<f32>(select(_e796, _e331.member_1.x, (_e331.member_1.x > _e796)), select(_e797, _e331.member_1.y, (_e331.member_1.y > _e797)), select(_e798, _e331.member_1.z, (_e331.member_1.z > _e798))));
phi_1528_ = type_25(vec3<f32>(select(_e772, _e706, (_e706 < _e772)), select(_e773, _e710, (_e710 < _e773)), select(_e774, _e714, (_e714 < _e774))), vec3<f32>(select(_e775, _e718, (_e718 > _e775)), select(_e776, _e722, (_e722 > _e776)), select(_e777, _e726, (_e726 > _e777))));
} else {
phi_1525_ = _e327;
phi_1526_ = _e329;
phi_1527_ = _e331;
phi_1528_ = _e333;
}
let _e980 = phi_1525_;
let _e982 = phi_1526_;
let _e984 = phi_1527_;
let _e986 = phi_1528_;
phi_378_ = (_e325 + 1u);
phi_381_ = _e980;
phi_383_ = _e982;
phi_385_ = _e984;
phi_387_ = _e986;
} else {
phi_378_ = u32();
phi_381_ = type_25();
phi_383_ = type_25();
phi_385_ = type_25();
phi_387_ = type_25();
}
let _e989 = phi_378_;
let _e991 = phi_381_;
let _e993 = phi_383_;
let _e995 = phi_385_;
let _e997 = phi_387_;
continue;
continuing {
phi_377_ = _e989;
phi_380_ = _e991;
phi_382_ = _e993;
phi_384_ = _e995;
phi_386_ = _e997;
break if !(_e337);
}
}
phi_278_ = (_e233 + 1u);
let _e1229 = local_29;
phi_281_ = _e1229;
let _e1232 = local_30;
phi_283_ = _e1232;
let _e1235 = local_31;
phi_285_ = _e1235;
let _e1238 = local_32;
phi_287_ = _e1238;
} else {
phi_278_ = u32();
phi_281_ = type_25();
phi_283_ = type_25();
phi_285_ = type_25();
phi_287_ = type_25();
}
let _e1001 = phi_278_;
let _e1003 = phi_281_;
let _e1005 = phi_283_;
let _e1007 = phi_285_;
let _e1009 = phi_287_;
continue;
continuing {
phi_277_ = _e1001;
phi_280_ = _e1003;
phi_282_ = _e1005;
phi_284_ = _e1007;
phi_286_ = _e1009;
break if !(_e323);
}
}
let _e1012 = local_21;
let _e1015 = local_22;
let _e1018 = local_23;
let _e1021 = local_24;
let _e1042 = local_25;
let _e1045 = local_26;
let _e1066 = local_27;
let _e1069 = local_28;
global_2.member[_e87] = _e1012.member.x;
global_2.member[(_e85 + _e87)] = _e1012.member.y;
global_2.member[((2u * _e85) + _e87)] = _e1012.member.z;
global_2.member[((3u * _e85) + _e87)] = _e1015.member_1.x;
global_2.member[((4u * _e85) + _e87)] = _e1015.member_1.y;
global_2.member[((5u * _e85) + _e87)] = _e1015.member_1.z;
global_2.member[((6u * _e85) + _e87)] = ((_e1018.member.x + _e1021.member_1.x) * 0.5f);
global_2.member[((7u * _e85) + _e87)] = ((_e1018.member.y + _e1021.member_1.y) * 0.5f);
global_2.member[((8u * _e85) + _e87)] = ((_e1018.member.z + _e1021.member_1.z) * 0.5f);
global_2.member[((9u * _e85) + _e87)] = ((_e1021.member_1.x - _e1018.member.x) * 0.5f);
global_2.member[((10u * _e85) + _e87)] = ((_e1021.member_1.y - _e1018.member.y) * 0.5f);
global_2.member[((11u * _e85) + _e87)] = ((_e1021.member_1.z - _e1018.member.z) * 0.5f);
global_2.member[((12u * _e85) + _e87)] = ((_e1042.member.x + _e1045.member_1.x) * 0.5f);
global_2.member[((13u * _e85) + _e87)] = ((_e1042.member.y + _e1045.member_1.y) * 0.5f);
global_2.member[((14u * _e85) + _e87)] = ((_e1042.member.z + _e1045.member_1.z) * 0.5f);
global_2.member[((15u * _e85) + _e87)] = ((_e1045.member_1.x - _e1042.member.x) * 0.5f);
global_2.member[((16u * _e85) + _e87)] = ((_e1045.member_1.y - _e1042.member.y) * 0.5f);
global_2.member[((17u * _e85) + _e87)] = ((_e1045.member_1.z - _e1042.member.z) * 0.5f);
global_2.member[((18u * _e85) + _e87)] = _e1066.member.x;
global_2.member[((19u * _e85) + _e87)] = _e1066.member.y;
global_2.member[((20u * _e85) + _e87)] = _e1066.member.z;
global_2.member[((21u * _e85) + _e87)] = _e1069.member_1.x;
global_2.member[((22u * _e85) + _e87)] = _e1069.member_1.y;
global_2.member[((23u * _e85) + _e87)] = _e1069.member_1.z;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
