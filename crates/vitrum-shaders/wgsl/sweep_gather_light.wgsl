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
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
}
struct type_11 {
member: u32,
member_1: u32,
}
struct type_12 {
member: type_11,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
}
struct type_13 {
member: type_5,
member_1: f32,
member_2: f32,
}
struct type_14 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: u32,
member_4: type_11,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: u32,
member_13: u32,
member_14: type_2,
member_15: u32,
member_16: u32,
member_17: type_11,
member_18: type_12,
member_19: type_5,
member_20: type_13,
member_21: f32,
member_22: f32,
member_23: f32,
member_24: f32,
}
struct type_16 {
member: array<f32>,
}
struct type_20 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_21 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_22 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: f32,
member_7: f32,
member_8: f32,
member_9: i32,
member_10: i32,
member_11: type_2,
member_12: u32,
member_13: type_2,
member_14: u32,
member_15: u32,
}
struct type_23 {
member: u32,
member_1: u32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_24 {
member: type_5,
member_1: type_5,
}
struct type_25 {
member: type_7,
member_1: u32,
}
struct type_26 {
member: type_2,
member_1: u32,
member_2: type_20,
member_3: type_11,
member_4: type_11,
member_5: u32,
member_6: u32,
member_7: type_21,
member_8: type_22,
member_9: type_22,
member_10: type_23,
member_11: type_24,
member_12: type_14,
member_13: type_21,
member_14: type_4,
member_15: type_9,
member_16: type_25,
member_17: type_25,
member_18: type_25,
member_19: type_25,
member_20: type_10,
member_21: f32,
member_22: f32,
member_23: type_6,
}
struct type_27 {
member: type_26,
}
struct type_28 {
member: u32,
member_1: u32,
member_2: f32,
member_3: f32,
}
struct type_29 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: f32,
member_3: f32,
member_4: f32,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_27;
@group(0) @binding(3)
var<storage, read_write> global_2: type_16;
@group(0) @binding(1)
var<storage> global_3: type_16;
@group(0) @binding(2)
var<storage> global_4: type_16;
fn function_() {
var local: type_28;
var phi_272_: i32;
var phi_315_: i32;
var phi_508_: i32;
var phi_551_: i32;
var phi_741_: i32;
var phi_784_: i32;
var phi_919_: f32;
var phi_920_: f32;
var phi_979_: i32;
var phi_1022_: i32;
var phi_1215_: i32;
var phi_1258_: i32;
var phi_1451_: i32;
var phi_1494_: i32;
var phi_1684_: i32;
var phi_1727_: i32;
var phi_1917_: i32;
var phi_1960_: i32;
var phi_2150_: i32;
var phi_2193_: i32;
var phi_3968_: f32;
var phi_3969_: f32;
var phi_4891_: f32;
var phi_4892_: f32;
var phi_5814_: f32;
var phi_5815_: f32;
var phi_6737_: f32;
var phi_6738_: f32;
var phi_7660_: f32;
var phi_7661_: f32;
var phi_8583_: f32;
var phi_8584_: f32;
var phi_9506_: f32;
var phi_9507_: f32;
var phi_10429_: f32;
var phi_10430_: f32;
var phi_11352_: f32;
var phi_11353_: f32;
var phi_11364_: type_29;
let _e43 = global;
let _e53 = global_1.member.member_2;
let _e56 = global_1.member.member;
let _e64 = (_e43.x + _e53.member);
let _e66 = (_e43.y + _e53.member_1);
if (_e64 < _e53.member_2) {
if (_e66 < _e53.member_3) {
let _e69 = (_e56.member * _e56.member_1);
let _e71 = ((_e66 * _e56.member) + _e64);
let _e76 = global_1.member.member_10.member;
let _e78 = bitcast<i32>((_e66 * _e76));
let _e82 = global_1.member.member_10.member_1;
let _e84 = bitcast<i32>((_e76 * _e82));
let _e85 = bitcast<i32>(_e64);
let _e86 = (_e78 + _e85);
let _e88 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e90 = select(_e88, _e86, (_e86 < _e88));
let _e96 = global_4.member[bitcast<u32>(select(0i, _e90, (_e90 > 0i)))];
let _e98 = ((_e84 + _e78) + _e85);
let _e100 = select(_e88, _e98, (_e98 < _e88));
let _e106 = global_4.member[bitcast<u32>(select(0i, _e100, (_e100 > 0i)))];
let _e107 = -(_e96);
let _e108 = -(_e106);
local.member = _e64;
local.member_1 = _e66;
local.member_2 = _e107;
local.member_3 = _e108;
let _e117 = (((_e56.member_2 == 3u) || (_e56.member_2 == 4u)) || (_e56.member_2 == 5u));
let _e120 = global_1.member.member_10.member;
let _e121 = bitcast<i32>(_e120);
let _e124 = local.member_1;
let _e126 = (bitcast<i32>(_e124) * _e121);
let _e127 = local.member_2;
let _e128 = -(32768f);
let _e130 = select(_e128, _e127, (_e127 > _e128));
let _e132 = select(32768f, _e130, (_e130 < 32768f));
let _e139 = select(0i, select(select(i32(_e132), i32(-2147483648), (_e132 < -2147483600f)), 2147483647i, (_e132 > 2147483500f)), (_e132 == _e132));
let _e143 = (_e139 - select(0i, 1i, (_e132 < f32(_e139))));
let _e145 = (_e127 - f32(_e143));
let _e146 = (_e143 < 0i);
if _e146 {
phi_272_ = (_e143 + 1i);
} else {
phi_272_ = _e143;
}
let _e149 = phi_272_;
let _e150 = select(1i, -1i, _e146);
let _e152 = select(_e145, (1f - _e145), _e146);
let _e153 = local.member_3;
let _e155 = select(_e128, _e153, (_e153 > _e128));
let _e157 = select(32768f, _e155, (_e155 < 32768f));
let _e164 = select(0i, select(select(i32(_e157), i32(-2147483648), (_e157 < -2147483600f)), 2147483647i, (_e157 > 2147483500f)), (_e157 == _e157));
let _e168 = (_e164 - select(0i, 1i, (_e157 < f32(_e164))));
let _e170 = (_e153 - f32(_e168));
let _e171 = (_e168 < 0i);
if _e171 {
phi_315_ = (_e168 + 1i);
} else {
phi_315_ = _e168;
}
let _e174 = phi_315_;
let _e180 = local.member;
let _e183 = (((_e126 + (_e174 * _e121)) + bitcast<i32>(_e180)) + _e149);
let _e185 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e187 = select(_e185, _e183, (_e183 < _e185));
let _e192 = global_3.member[bitcast<u32>(select(0i, _e187, (_e187 > 0i)))];
let _e193 = (_e183 + _e150);
let _e195 = select(_e185, _e193, (_e193 < _e185));
let _e200 = global_3.member[bitcast<u32>(select(0i, _e195, (_e195 > 0i)))];
let _e203 = (_e192 + ((_e200 - _e192) * _e152));
let _e207 = local.member;
let _e210 = (((_e126 + ((_e174 + select(1i, -1i, _e171)) * _e121)) + bitcast<i32>(_e207)) + _e149);
let _e212 = select(_e185, _e210, (_e210 < _e185));
let _e217 = global_3.member[bitcast<u32>(select(0i, _e212, (_e212 > 0i)))];
let _e218 = (_e210 + _e150);
let _e220 = select(_e185, _e218, (_e218 < _e185));
let _e225 = global_3.member[bitcast<u32>(select(0i, _e220, (_e220 > 0i)))];
let _e229 = local.member;
let _e232 = local.member_2;
let _e233 = (f32(bitcast<i32>(_e229)) + _e232);
let _e234 = local.member_1;
let _e237 = local.member_3;
let _e238 = (f32(bitcast<i32>(_e234)) + _e237);
let _e240 = (f32(_e121) - 1f);
let _e241 = global_1.member.member_10.member_1;
let _e244 = (f32(bitcast<i32>(_e241)) - 1f);
let _e255 = select(1f, (_e203 + (((_e217 + ((_e225 - _e217) * _e152)) - _e203) * select(_e170, (1f - _e170), _e171))), ((((_e233 >= 0f) && (_e233 <= _e240)) && (_e238 >= 0f)) && (_e238 <= _e244)));
if _e117 {
phi_919_ = _e255;
phi_920_ = _e255;
} else {
let _e257 = bitcast<i32>((_e120 * _e241));
let _e258 = local.member_1;
let _e261 = (_e257 + (bitcast<i32>(_e258) * _e121));
let _e262 = local.member_2;
let _e264 = select(_e128, _e262, (_e262 > _e128));
let _e266 = select(32768f, _e264, (_e264 < 32768f));
let _e273 = select(0i, select(select(i32(_e266), i32(-2147483648), (_e266 < -2147483600f)), 2147483647i, (_e266 > 2147483500f)), (_e266 == _e266));
let _e277 = (_e273 - select(0i, 1i, (_e266 < f32(_e273))));
let _e279 = (_e262 - f32(_e277));
let _e280 = (_e277 < 0i);
if _e280 {
phi_508_ = (_e277 + 1i);
} else {
phi_508_ = _e277;
}
let _e283 = phi_508_;
let _e284 = select(1i, -1i, _e280);
let _e286 = select(_e279, (1f - _e279), _e280);
let _e287 = local.member_3;
let _e289 = select(_e128, _e287, (_e287 > _e128));
let _e291 = select(32768f, _e289, (_e289 < 32768f));
let _e298 = select(0i, select(select(i32(_e291), i32(-2147483648), (_e291 < -2147483600f)), 2147483647i, (_e291 > 2147483500f)), (_e291 == _e291));
let _e302 = (_e298 - select(0i, 1i, (_e291 < f32(_e298))));
let _e304 = (_e287 - f32(_e302));
let _e305 = (_e302 < 0i);
if _e305 {
phi_551_ = (_e302 + 1i);
} else {
phi_551_ = _e302;
}
let _e308 = phi_551_;
let _e314 = local.member;
let _e317 = (((_e261 + (_e308 * _e121)) + bitcast<i32>(_e314)) + _e283);
let _e319 = select(_e185, _e317, (_e317 < _e185));
let _e324 = global_3.member[bitcast<u32>(select(0i, _e319, (_e319 > 0i)))];
let _e325 = (_e317 + _e284);
let _e327 = select(_e185, _e325, (_e325 < _e185));
let _e332 = global_3.member[bitcast<u32>(select(0i, _e327, (_e327 > 0i)))];
let _e335 = (_e324 + ((_e332 - _e324) * _e286));
let _e339 = local.member;
let _e342 = (((_e261 + ((_e308 + select(1i, -1i, _e305)) * _e121)) + bitcast<i32>(_e339)) + _e283);
let _e344 = select(_e185, _e342, (_e342 < _e185));
let _e349 = global_3.member[bitcast<u32>(select(0i, _e344, (_e344 > 0i)))];
let _e350 = (_e342 + _e284);
let _e352 = select(_e185, _e350, (_e350 < _e185));
let _e357 = global_3.member[bitcast<u32>(select(0i, _e352, (_e352 > 0i)))];
let _e361 = local.member;
let _e364 = local.member_2;
let _e365 = (f32(bitcast<i32>(_e361)) + _e364);
let _e366 = local.member_1;
let _e369 = local.member_3;
let _e370 = (f32(bitcast<i32>(_e366)) + _e369);
let _e383 = local.member_1;
let _e386 = ((2i * _e257) + (bitcast<i32>(_e383) * _e121));
let _e387 = local.member_2;
let _e389 = select(_e128, _e387, (_e387 > _e128));
let _e391 = select(32768f, _e389, (_e389 < 32768f));
let _e398 = select(0i, select(select(i32(_e391), i32(-2147483648), (_e391 < -2147483600f)), 2147483647i, (_e391 > 2147483500f)), (_e391 == _e391));
let _e402 = (_e398 - select(0i, 1i, (_e391 < f32(_e398))));
let _e404 = (_e387 - f32(_e402));
let _e405 = (_e402 < 0i);
if _e405 {
phi_741_ = (_e402 + 1i);
} else {
phi_741_ = _e402;
}
let _e408 = phi_741_;
let _e409 = select(1i, -1i, _e405);
let _e411 = select(_e404, (1f - _e404), _e405);
let _e412 = local.member_3;
let _e414 = select(_e128, _e412, (_e412 > _e128));
let _e416 = select(32768f, _e414, (_e414 < 32768f));
let _e423 = select(0i, select(select(i32(_e416), i32(-2147483648), (_e416 < -2147483600f)), 2147483647i, (_e416 > 2147483500f)), (_e416 == _e416));
let _e427 = (_e423 - select(0i, 1i, (_e416 < f32(_e423))));
let _e429 = (_e412 - f32(_e427));
let _e430 = (_e427 < 0i);
if _e430 {
phi_784_ = (_e427 + 1i);
} else {
phi_784_ = _e427;
}
let _e433 = phi_784_;
let _e439 = local.member;
let _e442 = (((_e386 + (_e433 * _e121)) + bitcast<i32>(_e439)) + _e408);
let _e444 = select(_e185, _e442, (_e442 < _e185));
let _e449 = global_3.member[bitcast<u32>(select(0i, _e444, (_e444 > 0i)))];
let _e450 = (_e442 + _e409);
let _e452 = select(_e185, _e450, (_e450 < _e185));
let _e457 = global_3.member[bitcast<u32>(select(0i, _e452, (_e452 > 0i)))];
let _e460 = (_e449 + ((_e457 - _e449) * _e411));
let _e464 = local.member;
let _e467 = (((_e386 + ((_e433 + select(1i, -1i, _e430)) * _e121)) + bitcast<i32>(_e464)) + _e408);
let _e469 = select(_e185, _e467, (_e467 < _e185));
let _e474 = global_3.member[bitcast<u32>(select(0i, _e469, (_e469 > 0i)))];
let _e475 = (_e467 + _e409);
let _e477 = select(_e185, _e475, (_e475 < _e185));
let _e482 = global_3.member[bitcast<u32>(select(0i, _e477, (_e477 > 0i)))];
let _e486 = local.member;
let _e489 = local.member_2;
let _e490 = (f32(bitcast<i32>(_e486)) + _e489);
let _e491 = local.member_1;
let _e494 = local.member_3;
let _e495 = (f32(bitcast<i32>(_e491)) + _e494);
phi_919_ = select(1f, (_e460 + (((_e474 + ((_e482 - _e474) * _e411)) - _e460) * select(_e429, (1f - _e429), _e430))), ((((_e490 >= 0f) && (_e490 <= _e240)) && (_e495 >= 0f)) && (_e495 <= _e244)));
phi_920_ = select(1f, (_e335 + (((_e349 + ((_e357 - _e349) * _e286)) - _e335) * select(_e304, (1f - _e304), _e305))), ((((_e365 >= 0f) && (_e365 <= _e240)) && (_e370 >= 0f)) && (_e370 <= _e244)));
}
let _e508 = phi_919_;
let _e510 = phi_920_;
let _e515 = global_1.member.member_11.member.member;
let _e517 = bitcast<i32>((_e120 * _e241));
let _e519 = local.member_1;
let _e522 = ((3i * _e517) + (bitcast<i32>(_e519) * _e121));
let _e523 = local.member_2;
let _e525 = select(_e128, _e523, (_e523 > _e128));
let _e527 = select(32768f, _e525, (_e525 < 32768f));
let _e534 = select(0i, select(select(i32(_e527), i32(-2147483648), (_e527 < -2147483600f)), 2147483647i, (_e527 > 2147483500f)), (_e527 == _e527));
let _e538 = (_e534 - select(0i, 1i, (_e527 < f32(_e534))));
let _e540 = (_e523 - f32(_e538));
let _e541 = (_e538 < 0i);
if _e541 {
phi_979_ = (_e538 + 1i);
} else {
phi_979_ = _e538;
}
let _e544 = phi_979_;
let _e545 = select(1i, -1i, _e541);
let _e547 = select(_e540, (1f - _e540), _e541);
let _e548 = local.member_3;
let _e550 = select(_e128, _e548, (_e548 > _e128));
let _e552 = select(32768f, _e550, (_e550 < 32768f));
let _e559 = select(0i, select(select(i32(_e552), i32(-2147483648), (_e552 < -2147483600f)), 2147483647i, (_e552 > 2147483500f)), (_e552 == _e552));
let _e563 = (_e559 - select(0i, 1i, (_e552 < f32(_e559))));
let _e565 = (_e548 - f32(_e563));
let _e566 = (_e563 < 0i);
if _e566 {
phi_1022_ = (_e563 + 1i);
} else {
phi_1022_ = _e563;
}
let _e569 = phi_1022_;
let _e575 = local.member;
let _e578 = (((_e522 + (_e569 * _e121)) + bitcast<i32>(_e575)) + _e544);
let _e580 = select(_e185, _e578, (_e578 < _e185));
let _e585 = global_3.member[bitcast<u32>(select(0i, _e580, (_e580 > 0i)))];
let _e586 = (_e578 + _e545);
let _e588 = select(_e185, _e586, (_e586 < _e185));
let _e593 = global_3.member[bitcast<u32>(select(0i, _e588, (_e588 > 0i)))];
let _e596 = (_e585 + ((_e593 - _e585) * _e547));
let _e600 = local.member;
let _e603 = (((_e522 + ((_e569 + select(1i, -1i, _e566)) * _e121)) + bitcast<i32>(_e600)) + _e544);
let _e605 = select(_e185, _e603, (_e603 < _e185));
let _e610 = global_3.member[bitcast<u32>(select(0i, _e605, (_e605 > 0i)))];
let _e611 = (_e603 + _e545);
let _e613 = select(_e185, _e611, (_e611 < _e185));
let _e618 = global_3.member[bitcast<u32>(select(0i, _e613, (_e613 > 0i)))];
let _e622 = local.member;
let _e625 = local.member_2;
let _e626 = (f32(bitcast<i32>(_e622)) + _e625);
let _e627 = local.member_1;
let _e630 = local.member_3;
let _e631 = (f32(bitcast<i32>(_e627)) + _e630);
let _e647 = global_1.member.member_11.member.member_1;
let _e649 = local.member_1;
let _e652 = ((4i * _e517) + (bitcast<i32>(_e649) * _e121));
let _e653 = local.member_2;
let _e655 = select(_e128, _e653, (_e653 > _e128));
let _e657 = select(32768f, _e655, (_e655 < 32768f));
let _e664 = select(0i, select(select(i32(_e657), i32(-2147483648), (_e657 < -2147483600f)), 2147483647i, (_e657 > 2147483500f)), (_e657 == _e657));
let _e668 = (_e664 - select(0i, 1i, (_e657 < f32(_e664))));
let _e670 = (_e653 - f32(_e668));
let _e671 = (_e668 < 0i);
if _e671 {
phi_1215_ = (_e668 + 1i);
} else {
phi_1215_ = _e668;
}
let _e674 = phi_1215_;
let _e675 = select(1i, -1i, _e671);
let _e677 = select(_e670, (1f - _e670), _e671);
let _e678 = local.member_3;
let _e680 = select(_e128, _e678, (_e678 > _e128));
let _e682 = select(32768f, _e680, (_e680 < 32768f));
let _e689 = select(0i, select(select(i32(_e682), i32(-2147483648), (_e682 < -2147483600f)), 2147483647i, (_e682 > 2147483500f)), (_e682 == _e682));
let _e693 = (_e689 - select(0i, 1i, (_e682 < f32(_e689))));
let _e695 = (_e678 - f32(_e693));
let _e696 = (_e693 < 0i);
if _e696 {
phi_1258_ = (_e693 + 1i);
} else {
phi_1258_ = _e693;
}
let _e699 = phi_1258_;
let _e705 = local.member;
let _e708 = (((_e652 + (_e699 * _e121)) + bitcast<i32>(_e705)) + _e674);
let _e710 = select(_e185, _e708, (_e708 < _e185));
let _e715 = global_3.member[bitcast<u32>(select(0i, _e710, (_e710 > 0i)))];
let _e716 = (_e708 + _e675);
let _e718 = select(_e185, _e716, (_e716 < _e185));
let _e723 = global_3.member[bitcast<u32>(select(0i, _e718, (_e718 > 0i)))];
let _e726 = (_e715 + ((_e723 - _e715) * _e677));
let _e730 = local.member;
let _e733 = (((_e652 + ((_e699 + select(1i, -1i, _e696)) * _e121)) + bitcast<i32>(_e730)) + _e674);
let _e735 = select(_e185, _e733, (_e733 < _e185));
let _e740 = global_3.member[bitcast<u32>(select(0i, _e735, (_e735 > 0i)))];
let _e741 = (_e733 + _e675);
let _e743 = select(_e185, _e741, (_e741 < _e185));
let _e748 = global_3.member[bitcast<u32>(select(0i, _e743, (_e743 > 0i)))];
let _e752 = local.member;
let _e755 = local.member_2;
let _e756 = (f32(bitcast<i32>(_e752)) + _e755);
let _e757 = local.member_1;
let _e760 = local.member_3;
let _e761 = (f32(bitcast<i32>(_e757)) + _e760);
let _e777 = global_1.member.member_11.member.member_2;
let _e779 = local.member_1;
let _e782 = ((5i * _e517) + (bitcast<i32>(_e779) * _e121));
let _e783 = local.member_2;
let _e785 = select(_e128, _e783, (_e783 > _e128));
let _e787 = select(32768f, _e785, (_e785 < 32768f));
let _e794 = select(0i, select(select(i32(_e787), i32(-2147483648), (_e787 < -2147483600f)), 2147483647i, (_e787 > 2147483500f)), (_e787 == _e787));
let _e798 = (_e794 - select(0i, 1i, (_e787 < f32(_e794))));
let _e800 = (_e783 - f32(_e798));
let _e801 = (_e798 < 0i);
if _e801 {
phi_1451_ = (_e798 + 1i);
} else {
phi_1451_ = _e798;
}
let _e804 = phi_1451_;
let _e805 = select(1i, -1i, _e801);
let _e807 = select(_e800, (1f - _e800), _e801);
let _e808 = local.member_3;
let _e810 = select(_e128, _e808, (_e808 > _e128));
let _e812 = select(32768f, _e810, (_e810 < 32768f));
let _e819 = select(0i, select(select(i32(_e812), i32(-2147483648), (_e812 < -2147483600f)), 2147483647i, (_e812 > 2147483500f)), (_e812 == _e812));
let _e823 = (_e819 - select(0i, 1i, (_e812 < f32(_e819))));
let _e825 = (_e808 - f32(_e823));
let _e826 = (_e823 < 0i);
if _e826 {
phi_1494_ = (_e823 + 1i);
} else {
phi_1494_ = _e823;
}
let _e829 = phi_1494_;
let _e835 = local.member;
let _e838 = (((_e782 + (_e829 * _e121)) + bitcast<i32>(_e835)) + _e804);
let _e840 = select(_e185, _e838, (_e838 < _e185));
let _e845 = global_3.member[bitcast<u32>(select(0i, _e840, (_e840 > 0i)))];
let _e846 = (_e838 + _e805);
let _e848 = select(_e185, _e846, (_e846 < _e185));
let _e853 = global_3.member[bitcast<u32>(select(0i, _e848, (_e848 > 0i)))];
let _e856 = (_e845 + ((_e853 - _e845) * _e807));
let _e860 = local.member;
let _e863 = (((_e782 + ((_e829 + select(1i, -1i, _e826)) * _e121)) + bitcast<i32>(_e860)) + _e804);
let _e865 = select(_e185, _e863, (_e863 < _e185));
let _e870 = global_3.member[bitcast<u32>(select(0i, _e865, (_e865 > 0i)))];
let _e871 = (_e863 + _e805);
let _e873 = select(_e185, _e871, (_e871 < _e185));
let _e878 = global_3.member[bitcast<u32>(select(0i, _e873, (_e873 > 0i)))];
let _e882 = local.member;
let _e885 = local.member_2;
let _e886 = (f32(bitcast<i32>(_e882)) + _e885);
let _e887 = local.member_1;
let _e890 = local.member_3;
let _e891 = (f32(bitcast<i32>(_e887)) + _e890);
let _e904 = local.member_1;
let _e907 = ((6i * _e517) + (bitcast<i32>(_e904) * _e121));
let _e908 = local.member_2;
let _e910 = select(_e128, _e908, (_e908 > _e128));
let _e912 = select(32768f, _e910, (_e910 < 32768f));
let _e919 = select(0i, select(select(i32(_e912), i32(-2147483648), (_e912 < -2147483600f)), 2147483647i, (_e912 > 2147483500f)), (_e912 == _e912));
let _e923 = (_e919 - select(0i, 1i, (_e912 < f32(_e919))));
let _e925 = (_e908 - f32(_e923));
let _e926 = (_e923 < 0i);
if _e926 {
phi_1684_ = (_e923 + 1i);
} else {
phi_1684_ = _e923;
}
let _e929 = phi_1684_;
let _e930 = select(1i, -1i, _e926);
let _e932 = select(_e925, (1f - _e925), _e926);
let _e933 = local.member_3;
let _e935 = select(_e128, _e933, (_e933 > _e128));
let _e937 = select(32768f, _e935, (_e935 < 32768f));
let _e944 = select(0i, select(select(i32(_e937), i32(-2147483648), (_e937 < -2147483600f)), 2147483647i, (_e937 > 2147483500f)), (_e937 == _e937));
let _e948 = (_e944 - select(0i, 1i, (_e937 < f32(_e944))));
let _e950 = (_e933 - f32(_e948));
let _e951 = (_e948 < 0i);
if _e951 {
phi_1727_ = (_e948 + 1i);
} else {
phi_1727_ = _e948;
}
let _e954 = phi_1727_;
let _e960 = local.member;
let _e963 = (((_e907 + (_e954 * _e121)) + bitcast<i32>(_e960)) + _e929);
let _e965 = select(_e185, _e963, (_e963 < _e185));
let _e970 = global_3.member[bitcast<u32>(select(0i, _e965, (_e965 > 0i)))];
let _e971 = (_e963 + _e930);
let _e973 = select(_e185, _e971, (_e971 < _e185));
let _e978 = global_3.member[bitcast<u32>(select(0i, _e973, (_e973 > 0i)))];
let _e981 = (_e970 + ((_e978 - _e970) * _e932));
let _e985 = local.member;
let _e988 = (((_e907 + ((_e954 + select(1i, -1i, _e951)) * _e121)) + bitcast<i32>(_e985)) + _e929);
let _e990 = select(_e185, _e988, (_e988 < _e185));
let _e995 = global_3.member[bitcast<u32>(select(0i, _e990, (_e990 > 0i)))];
let _e996 = (_e988 + _e930);
let _e998 = select(_e185, _e996, (_e996 < _e185));
let _e1003 = global_3.member[bitcast<u32>(select(0i, _e998, (_e998 > 0i)))];
let _e1007 = local.member;
let _e1010 = local.member_2;
let _e1011 = (f32(bitcast<i32>(_e1007)) + _e1010);
let _e1012 = local.member_1;
let _e1015 = local.member_3;
let _e1016 = (f32(bitcast<i32>(_e1012)) + _e1015);
let _e1029 = local.member_1;
let _e1032 = ((7i * _e517) + (bitcast<i32>(_e1029) * _e121));
let _e1033 = local.member_2;
let _e1035 = select(_e128, _e1033, (_e1033 > _e128));
let _e1037 = select(32768f, _e1035, (_e1035 < 32768f));
let _e1044 = select(0i, select(select(i32(_e1037), i32(-2147483648), (_e1037 < -2147483600f)), 2147483647i, (_e1037 > 2147483500f)), (_e1037 == _e1037));
let _e1048 = (_e1044 - select(0i, 1i, (_e1037 < f32(_e1044))));
let _e1050 = (_e1033 - f32(_e1048));
let _e1051 = (_e1048 < 0i);
if _e1051 {
phi_1917_ = (_e1048 + 1i);
} else {
phi_1917_ = _e1048;
}
let _e1054 = phi_1917_;
let _e1055 = select(1i, -1i, _e1051);
let _e1057 = select(_e1050, (1f - _e1050), _e1051);
let _e1058 = local.member_3;
let _e1060 = select(_e128, _e1058, (_e1058 > _e128));
let _e1062 = select(32768f, _e1060, (_e1060 < 32768f));
let _e1069 = select(0i, select(select(i32(_e1062), i32(-2147483648), (_e1062 < -2147483600f)), 2147483647i, (_e1062 > 2147483500f)), (_e1062 == _e1062));
let _e1073 = (_e1069 - select(0i, 1i, (_e1062 < f32(_e1069))));
let _e1075 = (_e1058 - f32(_e1073));
let _e1076 = (_e1073 < 0i);
if _e1076 {
phi_1960_ = (_e1073 + 1i);
} else {
phi_1960_ = _e1073;
}
let _e1079 = phi_1960_;
let _e1085 = local.member;
let _e1088 = (((_e1032 + (_e1079 * _e121)) + bitcast<i32>(_e1085)) + _e1054);
let _e1090 = select(_e185, _e1088, (_e1088 < _e185));
let _e1095 = global_3.member[bitcast<u32>(select(0i, _e1090, (_e1090 > 0i)))];
let _e1096 = (_e1088 + _e1055);
let _e1098 = select(_e185, _e1096, (_e1096 < _e185));
let _e1103 = global_3.member[bitcast<u32>(select(0i, _e1098, (_e1098 > 0i)))];
let _e1106 = (_e1095 + ((_e1103 - _e1095) * _e1057));
let _e1110 = local.member;
let _e1113 = (((_e1032 + ((_e1079 + select(1i, -1i, _e1076)) * _e121)) + bitcast<i32>(_e1110)) + _e1054);
let _e1115 = select(_e185, _e1113, (_e1113 < _e185));
let _e1120 = global_3.member[bitcast<u32>(select(0i, _e1115, (_e1115 > 0i)))];
let _e1121 = (_e1113 + _e1055);
let _e1123 = select(_e185, _e1121, (_e1121 < _e185));
let _e1128 = global_3.member[bitcast<u32>(select(0i, _e1123, (_e1123 > 0i)))];
let _e1132 = local.member;
let _e1135 = local.member_2;
let _e1136 = (f32(bitcast<i32>(_e1132)) + _e1135);
let _e1137 = local.member_1;
let _e1140 = local.member_3;
let _e1141 = (f32(bitcast<i32>(_e1137)) + _e1140);
let _e1154 = local.member_1;
let _e1157 = ((8i * _e517) + (bitcast<i32>(_e1154) * _e121));
let _e1158 = local.member_2;
let _e1160 = select(_e128, _e1158, (_e1158 > _e128));
let _e1162 = select(32768f, _e1160, (_e1160 < 32768f));
let _e1169 = select(0i, select(select(i32(_e1162), i32(-2147483648), (_e1162 < -2147483600f)), 2147483647i, (_e1162 > 2147483500f)), (_e1162 == _e1162));
let _e1173 = (_e1169 - select(0i, 1i, (_e1162 < f32(_e1169))));
let _e1175 = (_e1158 - f32(_e1173));
let _e1176 = (_e1173 < 0i);
if _e1176 {
phi_2150_ = (_e1173 + 1i);
} else {
phi_2150_ = _e1173;
}
let _e1179 = phi_2150_;
let _e1180 = select(1i, -1i, _e1176);
let _e1182 = select(_e1175, (1f - _e1175), _e1176);
let _e1183 = local.member_3;
let _e1185 = select(_e128, _e1183, (_e1183 > _e128));
let _e1187 = select(32768f, _e1185, (_e1185 < 32768f));
let _e1194 = select(0i, select(select(i32(_e1187), i32(-2147483648), (_e1187 < -2147483600f)), 2147483647i, (_e1187 > 2147483500f)), (_e1187 == _e1187));
let _e1198 = (_e1194 - select(0i, 1i, (_e1187 < f32(_e1194))));
let _e1200 = (_e1183 - f32(_e1198));
let _e1201 = (_e1198 < 0i);
if _e1201 {
phi_2193_ = (_e1198 + 1i);
} else {
phi_2193_ = _e1198;
}
let _e1204 = phi_2193_;
let _e1210 = local.member;
let _e1213 = (((_e1157 + (_e1204 * _e121)) + bitcast<i32>(_e1210)) + _e1179);
let _e1215 = select(_e185, _e1213, (_e1213 < _e185));
let _e1220 = global_3.member[bitcast<u32>(select(0i, _e1215, (_e1215 > 0i)))];
let _e1221 = (_e1213 + _e1180);
let _e1223 = select(_e185, _e1221, (_e1221 < _e185));
let _e1228 = global_3.member[bitcast<u32>(select(0i, _e1223, (_e1223 > 0i)))];
let _e1231 = (_e1220 + ((_e1228 - _e1220) * _e1182));
let _e1235 = local.member;
let _e1238 = (((_e1157 + ((_e1204 + select(1i, -1i, _e1201)) * _e121)) + bitcast<i32>(_e1235)) + _e1179);
let _e1240 = select(_e185, _e1238, (_e1238 < _e185));
let _e1245 = global_3.member[bitcast<u32>(select(0i, _e1240, (_e1240 > 0i)))];
let _e1246 = (_e1238 + _e1180);
let _e1248 = select(_e185, _e1246, (_e1246 < _e185));
let _e1253 = global_3.member[bitcast<u32>(select(0i, _e1248, (_e1248 > 0i)))];
let _e1257 = local.member;
let _e1260 = local.member_2;
let _e1261 = (f32(bitcast<i32>(_e1257)) + _e1260);
let _e1262 = local.member_1;
let _e1265 = local.member_3;
let _e1266 = (f32(bitcast<i32>(_e1262)) + _e1265);
let _e1277 = select(1f, (_e1231 + (((_e1245 + ((_e1253 - _e1245) * _e1182)) - _e1231) * select(_e1200, (1f - _e1200), _e1201))), ((((_e1261 >= 0f) && (_e1261 <= _e240)) && (_e1266 >= 0f)) && (_e1266 <= _e244)));
let _e1281 = global_1.member.member_11.member;
let _e1288 = global_1.member.member_7.member_2;
let _e1291 = (1f / select(1e-6f, _e1281.member_2, (_e1281.member_2 > 1e-6f)));
let _e1295 = global_1.member.member_10.member_5;
let _e1296 = (_e1288 * _e1295);
let _e1301 = global_1.member.member_10.member_6;
let _e1303 = (((_e1281.member * _e1291) - _e1301) * _e1296);
let _e1308 = global_1.member.member_10.member_7;
let _e1310 = (((_e1281.member_1 * _e1291) - _e1308) * _e1296);
let _e1312 = vec3<f32>(select(_e515, (_e596 + (((_e610 + ((_e618 - _e610) * _e547)) - _e596) * select(_e565, (1f - _e565), _e566))), ((((_e626 >= 0f) && (_e626 <= _e240)) && (_e631 >= 0f)) && (_e631 <= _e244))), select(_e647, (_e726 + (((_e740 + ((_e748 - _e740) * _e677)) - _e726) * select(_e695, (1f - _e695), _e696))), ((((_e756 >= 0f) && (_e756 <= _e240)) && (_e761 >= 0f)) && (_e761 <= _e244))), select(_e777, (_e856 + (((_e870 + ((_e878 - _e870) * _e807)) - _e856) * select(_e825, (1f - _e825), _e826))), ((((_e886 >= 0f) && (_e886 <= _e240)) && (_e891 >= 0f)) && (_e891 <= _e244))));
let _e1314 = (select(0f, (_e981 + (((_e995 + ((_e1003 - _e995) * _e932)) - _e981) * select(_e950, (1f - _e950), _e951))), ((((_e1011 >= 0f) && (_e1011 <= _e240)) && (_e1016 >= 0f)) && (_e1016 <= _e244))) + (_e107 + _e1303));
let _e1316 = (select(0f, (_e1106 + (((_e1120 + ((_e1128 - _e1120) * _e1057)) - _e1106) * select(_e1075, (1f - _e1075), _e1076))), ((((_e1136 >= 0f) && (_e1136 <= _e240)) && (_e1141 >= 0f)) && (_e1141 <= _e244))) + (_e108 + _e1310));
let _e1317 = type_29(vec3<f32>(_e255, _e510, _e508), _e1312, _e1314, _e1316, _e1277);
let _e1320 = global_1.member.member_1;
if (true && !(((_e1320 & 6u) == 0u))) {
let _e1325 = bitcast<i32>(_e66);
let _e1326 = bitcast<i32>(_e76);
let _e1327 = (_e1325 * _e1326);
let _e1328 = (_e1327 + _e85);
let _e1330 = select(_e88, _e1328, (_e1328 < _e88));
let _e1336 = global_4.member[bitcast<u32>(select(0i, _e1330, (_e1330 > 0i)))];
let _e1338 = ((_e1327 + _e84) + _e85);
let _e1340 = select(_e88, _e1338, (_e1338 < _e88));
let _e1346 = global_4.member[bitcast<u32>(select(0i, _e1340, (_e1340 > 0i)))];
let _e1347 = (_e1327 + -1i);
let _e1348 = (_e1347 + _e85);
let _e1350 = select(_e88, _e1348, (_e1348 < _e88));
let _e1356 = global_4.member[bitcast<u32>(select(0i, _e1350, (_e1350 > 0i)))];
let _e1358 = ((_e1347 + _e84) + _e85);
let _e1360 = select(_e88, _e1358, (_e1358 < _e88));
let _e1366 = global_4.member[bitcast<u32>(select(0i, _e1360, (_e1360 > 0i)))];
let _e1367 = (_e1327 + 1i);
let _e1368 = (_e1367 + _e85);
let _e1370 = select(_e88, _e1368, (_e1368 < _e88));
let _e1376 = global_4.member[bitcast<u32>(select(0i, _e1370, (_e1370 > 0i)))];
let _e1378 = ((_e1367 + _e84) + _e85);
let _e1380 = select(_e88, _e1378, (_e1378 < _e88));
let _e1386 = global_4.member[bitcast<u32>(select(0i, _e1380, (_e1380 > 0i)))];
let _e1388 = ((_e1325 - 1i) * _e1326);
let _e1389 = (_e1388 + _e85);
let _e1391 = select(_e88, _e1389, (_e1389 < _e88));
let _e1397 = global_4.member[bitcast<u32>(select(0i, _e1391, (_e1391 > 0i)))];
let _e1399 = ((_e1388 + _e84) + _e85);
let _e1401 = select(_e88, _e1399, (_e1399 < _e88));
let _e1407 = global_4.member[bitcast<u32>(select(0i, _e1401, (_e1401 > 0i)))];
let _e1409 = ((_e1325 + 1i) * _e1326);
let _e1410 = (_e1409 + _e85);
let _e1412 = select(_e88, _e1410, (_e1410 < _e88));
let _e1418 = global_4.member[bitcast<u32>(select(0i, _e1412, (_e1412 > 0i)))];
let _e1420 = ((_e1409 + _e84) + _e85);
let _e1422 = select(_e88, _e1420, (_e1420 < _e88));
let _e1428 = global_4.member[bitcast<u32>(select(0i, _e1422, (_e1422 > 0i)))];
let _e1430 = select(0f, -1f, (_e85 > 0i));
let _e1433 = select(0f, -1f, (_e85 < (_e1326 - 1i)));
let _e1436 = select(0f, -1f, (false || (_e1325 > 0i)));
let _e1441 = select(0f, -1f, (false || (_e1325 < (bitcast<i32>(_e82) - 1i))));
let _e1443 = ((_e1336 - _e1356) * _e1430);
let _e1445 = ((_e1376 - _e1336) * _e1433);
let _e1447 = (0.5f * (_e1443 + _e1445));
let _e1451 = bitcast<f32>((bitcast<u32>(_e1443) & 2147483647u));
let _e1454 = bitcast<f32>((bitcast<u32>(_e1445) & 2147483647u));
let _e1457 = (2f * select(_e1454, _e1451, (_e1451 < _e1454)));
let _e1460 = bitcast<f32>((bitcast<u32>(_e1447) & 2147483647u));
let _e1462 = select(_e1457, _e1460, (_e1460 < _e1457));
let _e1470 = (1f + select(_e1447, select(0f, select(_e1462, -(_e1462), (_e1447 < 0f)), ((_e1443 * _e1445) > 0f)), (_e1447 > 0f)));
let _e1472 = ((_e1346 - _e1366) * _e1430);
let _e1474 = ((_e1386 - _e1346) * _e1433);
let _e1476 = (0.5f * (_e1472 + _e1474));
let _e1479 = bitcast<f32>((bitcast<u32>(_e1472) & 2147483647u));
let _e1482 = bitcast<f32>((bitcast<u32>(_e1474) & 2147483647u));
let _e1485 = (2f * select(_e1482, _e1479, (_e1479 < _e1482)));
let _e1488 = bitcast<f32>((bitcast<u32>(_e1476) & 2147483647u));
let _e1490 = select(_e1485, _e1488, (_e1488 < _e1485));
let _e1496 = select(0f, select(_e1490, -(_e1490), (_e1476 < 0f)), ((_e1472 * _e1474) > 0f));
let _e1498 = ((_e1336 - _e1397) * _e1436);
let _e1500 = ((_e1418 - _e1336) * _e1441);
let _e1502 = (0.5f * (_e1498 + _e1500));
let _e1505 = bitcast<f32>((bitcast<u32>(_e1498) & 2147483647u));
let _e1508 = bitcast<f32>((bitcast<u32>(_e1500) & 2147483647u));
let _e1511 = (2f * select(_e1508, _e1505, (_e1505 < _e1508)));
let _e1514 = bitcast<f32>((bitcast<u32>(_e1502) & 2147483647u));
let _e1516 = select(_e1511, _e1514, (_e1514 < _e1511));
let _e1522 = select(0f, select(_e1516, -(_e1516), (_e1502 < 0f)), ((_e1498 * _e1500) > 0f));
let _e1524 = ((_e1346 - _e1407) * _e1436);
let _e1526 = ((_e1428 - _e1346) * _e1441);
let _e1528 = (0.5f * (_e1524 + _e1526));
let _e1532 = bitcast<f32>((bitcast<u32>(_e1524) & 2147483647u));
let _e1535 = bitcast<f32>((bitcast<u32>(_e1526) & 2147483647u));
let _e1538 = (2f * select(_e1535, _e1532, (_e1532 < _e1535)));
let _e1541 = bitcast<f32>((bitcast<u32>(_e1528) & 2147483647u));
let _e1543 = select(_e1538, _e1541, (_e1541 < _e1538));
let _e1551 = (1f + select(_e1528, select(0f, select(_e1543, -(_e1543), (_e1528 < 0f)), ((_e1524 * _e1526) > 0f)), (_e1528 > 0f)));
let _e1556 = ((_e1470 * _e1470) + (_e1496 * _e1496));
let _e1559 = ((_e1522 * _e1522) + (_e1551 * _e1551));
let _e1567 = select((sqrt(select(0f, _e1556, (_e1556 > 0f))) * sqrt(select(0f, _e1559, (_e1559 > 0f)))), 1f, ((_e1320 & 4u) != 0u));
let _e1570 = (1e6f / select(1f, _e1277, (_e1277 > 1f)));
let _e1572 = select(_e1570, _e1567, (_e1567 < _e1570));
let _e1581 = type_29(vec3<f32>((_e255 * _e1572), (_e510 * _e1572), (_e508 * _e1572)), _e1317.member_1, _e1317.member_2, _e1317.member_3, _e1317.member_4);
phi_11364_ = type_29(_e1581.member, _e1581.member_1, _e1581.member_2, _e1581.member_3, (_e1277 * _e1572));
} else {
let _e1588 = local.member_2;
let _e1589 = (_e1588 + 0.5f);
let _e1591 = select(_e128, _e1589, (_e1589 > _e128));
let _e1593 = select(32768f, _e1591, (_e1591 < 32768f));
let _e1600 = select(0i, select(select(i32(_e1593), i32(-2147483648), (_e1593 < -2147483600f)), 2147483647i, (_e1593 > 2147483500f)), (_e1593 == _e1593));
let _e1608 = select((_e1600 - select(0i, 1i, (_e1593 < f32(_e1600)))), 0i, ((_e1588 >= -1f) && (_e1588 < 1f)));
let _e1609 = local.member_3;
let _e1610 = (_e1609 + 0.5f);
let _e1612 = select(_e128, _e1610, (_e1610 > _e128));
let _e1614 = select(32768f, _e1612, (_e1612 < 32768f));
let _e1621 = select(0i, select(select(i32(_e1614), i32(-2147483648), (_e1614 < -2147483600f)), 2147483647i, (_e1614 > 2147483500f)), (_e1614 == _e1614));
let _e1629 = select((_e1621 - select(0i, 1i, (_e1614 < f32(_e1621)))), 0i, ((_e1609 >= -1f) && (_e1609 < 1f)));
let _e1633 = select(1f, 0f, ((_e1303 == 0f) && (_e1310 == 0f)));
let _e1634 = local.member;
let _e1635 = local.member_1;
let _e1637 = f32((_e1608 + -1i));
let _e1638 = bitcast<i32>(_e76);
let _e1639 = bitcast<i32>(_e82);
let _e1640 = (_e1638 * _e1639);
let _e1641 = (2i * _e1640);
let _e1643 = (bitcast<i32>(_e1634) + _e1608);
let _e1644 = (_e1643 + -2i);
let _e1646 = (bitcast<i32>(_e1635) + _e1629);
let _e1647 = (_e1646 + -1i);
let _e1650 = ((_e1644 >= 0i) && (_e1644 < _e1638));
let _e1651 = (_e1647 >= 0i);
let _e1653 = (_e1647 < _e1639);
let _e1654 = ((_e1650 && _e1651) && _e1653);
let _e1655 = (_e1647 * _e1638);
let _e1656 = (_e1641 + _e1655);
let _e1657 = (_e1656 + _e1644);
let _e1659 = select(_e88, _e1657, (_e1657 < _e88));
let _e1664 = global_4.member[bitcast<u32>(select(0i, _e1659, (_e1659 > 0i)))];
let _e1666 = (_e1643 + -1i);
let _e1669 = ((_e1666 >= 0i) && (_e1666 < _e1638));
let _e1671 = ((_e1669 && _e1651) && _e1653);
let _e1672 = (_e1656 + _e1666);
let _e1674 = select(_e88, _e1672, (_e1672 < _e88));
let _e1679 = global_4.member[bitcast<u32>(select(0i, _e1674, (_e1674 > 0i)))];
let _e1680 = select(_e1303, _e1679, _e1671);
let _e1683 = ((_e1643 >= 0i) && (_e1643 < _e1638));
let _e1685 = ((_e1683 && _e1651) && _e1653);
let _e1686 = (_e1656 + _e1643);
let _e1688 = select(_e88, _e1686, (_e1686 < _e88));
let _e1693 = global_4.member[bitcast<u32>(select(0i, _e1688, (_e1688 > 0i)))];
let _e1694 = select(_e1303, _e1693, _e1685);
let _e1695 = (_e1637 - 0.5f);
let _e1698 = (_e1695 + (0.5f * (select(_e1303, _e1664, _e1654) + _e1680)));
let _e1699 = (_e1637 + 0.5f);
let _e1701 = (0.5f * (_e1680 + _e1694));
let _e1702 = (_e1699 + _e1701);
let _e1704 = (0.5f * (_e1698 + _e1702));
let _e1708 = bitcast<f32>((bitcast<u32>((_e1702 - _e1698)) & 2147483647u));
let _e1711 = (1f / select(0.0625f, _e1708, (_e1708 > 0.0625f)));
let _e1713 = ((-0.5f - _e1704) * _e1711);
let _e1715 = select(-0.5f, _e1713, (_e1713 > -0.5f));
let _e1717 = ((0.5f - _e1704) * _e1711);
let _e1719 = select(0.5f, _e1717, (_e1717 < 0.5f));
let _e1720 = (_e1719 - _e1715);
let _e1722 = select(0f, _e1720, (_e1720 > 0f));
let _e1724 = (0.5f * (_e1715 + _e1719));
let _e1730 = f32((_e1629 + -1i));
let _e1731 = (3i * _e1640);
let _e1732 = (_e1646 + -2i);
let _e1733 = (_e1732 >= 0i);
let _e1735 = (_e1732 < _e1639);
let _e1736 = ((_e1669 && _e1733) && _e1735);
let _e1737 = (_e1732 * _e1638);
let _e1738 = (_e1731 + _e1737);
let _e1739 = (_e1738 + _e1666);
let _e1741 = select(_e88, _e1739, (_e1739 < _e88));
let _e1746 = global_4.member[bitcast<u32>(select(0i, _e1741, (_e1741 > 0i)))];
let _e1748 = (_e1731 + _e1655);
let _e1749 = (_e1748 + _e1666);
let _e1751 = select(_e88, _e1749, (_e1749 < _e88));
let _e1756 = global_4.member[bitcast<u32>(select(0i, _e1751, (_e1751 > 0i)))];
let _e1757 = select(_e1310, _e1756, _e1671);
let _e1758 = (_e1646 >= 0i);
let _e1760 = (_e1646 < _e1639);
let _e1761 = ((_e1669 && _e1758) && _e1760);
let _e1762 = (_e1646 * _e1638);
let _e1763 = (_e1731 + _e1762);
let _e1764 = (_e1763 + _e1666);
let _e1766 = select(_e88, _e1764, (_e1764 < _e88));
let _e1771 = global_4.member[bitcast<u32>(select(0i, _e1766, (_e1766 > 0i)))];
let _e1772 = select(_e1310, _e1771, _e1761);
let _e1773 = (_e1730 - 0.5f);
let _e1776 = (_e1773 + (0.5f * (select(_e1310, _e1746, _e1736) + _e1757)));
let _e1777 = (_e1730 + 0.5f);
let _e1779 = (0.5f * (_e1757 + _e1772));
let _e1780 = (_e1777 + _e1779);
let _e1782 = (0.5f * (_e1776 + _e1780));
let _e1786 = bitcast<f32>((bitcast<u32>((_e1780 - _e1776)) & 2147483647u));
let _e1789 = (1f / select(0.0625f, _e1786, (_e1786 > 0.0625f)));
let _e1791 = ((-0.5f - _e1782) * _e1789);
let _e1793 = select(-0.5f, _e1791, (_e1791 > -0.5f));
let _e1795 = ((0.5f - _e1782) * _e1789);
let _e1797 = select(0.5f, _e1795, (_e1795 < 0.5f));
let _e1798 = (_e1797 - _e1793);
let _e1800 = select(0f, _e1798, (_e1798 > 0f));
let _e1802 = (0.5f * (_e1793 + _e1797));
let _e1807 = (8i * _e1640);
let _e1808 = (_e1807 + _e1655);
let _e1809 = (_e1808 + _e1666);
let _e1811 = select(_e185, _e1809, (_e1809 < _e185));
let _e1816 = global_3.member[bitcast<u32>(select(0i, _e1811, (_e1811 > 0i)))];
let _e1817 = select(_e1633, _e1816, _e1671);
let _e1818 = (_e1808 + _e1644);
let _e1820 = select(_e185, _e1818, (_e1818 < _e185));
let _e1825 = global_3.member[bitcast<u32>(select(0i, _e1820, (_e1820 > 0i)))];
let _e1827 = (_e1808 + _e1643);
let _e1829 = select(_e185, _e1827, (_e1827 < _e185));
let _e1834 = global_3.member[bitcast<u32>(select(0i, _e1829, (_e1829 > 0i)))];
let _e1835 = select(_e1633, _e1834, _e1685);
let _e1836 = (_e1807 + _e1737);
let _e1837 = (_e1836 + _e1666);
let _e1839 = select(_e185, _e1837, (_e1837 < _e185));
let _e1844 = global_3.member[bitcast<u32>(select(0i, _e1839, (_e1839 > 0i)))];
let _e1846 = (_e1807 + _e1762);
let _e1847 = (_e1846 + _e1666);
let _e1849 = select(_e185, _e1847, (_e1847 < _e185));
let _e1854 = global_3.member[bitcast<u32>(select(0i, _e1849, (_e1849 > 0i)))];
let _e1855 = select(_e1633, _e1854, _e1761);
let _e1856 = (_e1817 - select(_e1633, _e1825, _e1654));
let _e1857 = (_e1835 - _e1817);
let _e1859 = (0.5f * (_e1856 + _e1857));
let _e1862 = bitcast<f32>((bitcast<u32>(_e1856) & 2147483647u));
let _e1865 = bitcast<f32>((bitcast<u32>(_e1857) & 2147483647u));
let _e1868 = (2f * select(_e1865, _e1862, (_e1862 < _e1865)));
let _e1871 = bitcast<f32>((bitcast<u32>(_e1859) & 2147483647u));
let _e1873 = select(_e1868, _e1871, (_e1871 < _e1868));
let _e1881 = select(1e-20f, _e1817, (_e1817 > 1e-20f));
let _e1882 = (select(0f, select(_e1873, -(_e1873), (_e1859 < 0f)), ((_e1856 * _e1857) > 0f)) / _e1881);
let _e1884 = select(-1f, _e1882, (_e1882 > -1f));
let _e1887 = (_e1817 - select(_e1633, _e1844, _e1736));
let _e1888 = (_e1855 - _e1817);
let _e1890 = (0.5f * (_e1887 + _e1888));
let _e1893 = bitcast<f32>((bitcast<u32>(_e1887) & 2147483647u));
let _e1896 = bitcast<f32>((bitcast<u32>(_e1888) & 2147483647u));
let _e1899 = (2f * select(_e1896, _e1893, (_e1893 < _e1896)));
let _e1902 = bitcast<f32>((bitcast<u32>(_e1890) & 2147483647u));
let _e1904 = select(_e1899, _e1902, (_e1902 < _e1899));
let _e1911 = (select(0f, select(_e1904, -(_e1904), (_e1890 < 0f)), ((_e1887 * _e1888) > 0f)) / _e1881);
let _e1913 = select(-1f, _e1911, (_e1911 > -1f));
let _e1922 = ((_e1722 * _e1800) + (((select(1f, _e1884, (_e1884 < 1f)) * (_e1722 * select(_e1724, -(_e1724), (_e1702 < _e1698)))) * _e1800) + ((select(1f, _e1913, (_e1913 < 1f)) * _e1722) * (_e1800 * select(_e1802, -(_e1802), (_e1780 < _e1776))))));
let _e1924 = select(0f, _e1922, (_e1922 > 0f));
let _e1925 = (_e1655 + _e1666);
let _e1927 = select(_e185, _e1925, (_e1925 < _e185));
let _e1932 = global_3.member[bitcast<u32>(select(0i, _e1927, (_e1927 > 0i)))];
let _e1933 = select(_e1633, _e1932, _e1671);
if _e117 {
phi_3968_ = _e1933;
phi_3969_ = _e1933;
} else {
let _e1935 = ((_e1640 + _e1655) + _e1666);
let _e1937 = select(_e185, _e1935, (_e1935 < _e185));
let _e1942 = global_3.member[bitcast<u32>(select(0i, _e1937, (_e1937 > 0i)))];
let _e1945 = select(_e185, _e1672, (_e1672 < _e185));
let _e1950 = global_3.member[bitcast<u32>(select(0i, _e1945, (_e1945 > 0i)))];
phi_3968_ = select(_e1633, _e1950, _e1671);
phi_3969_ = select(_e1633, _e1942, _e1671);
}
let _e1953 = phi_3968_;
let _e1955 = phi_3969_;
let _e1964 = f32(_e1608);
let _e1965 = (_e1643 + 1i);
let _e1968 = ((_e1965 >= 0i) && (_e1965 < _e1638));
let _e1970 = ((_e1968 && _e1651) && _e1653);
let _e1971 = (_e1656 + _e1965);
let _e1973 = select(_e88, _e1971, (_e1971 < _e88));
let _e1978 = global_4.member[bitcast<u32>(select(0i, _e1973, (_e1973 > 0i)))];
let _e1979 = select(_e1303, _e1978, _e1970);
let _e1980 = (_e1964 - 0.5f);
let _e1981 = (_e1980 + _e1701);
let _e1982 = (_e1964 + 0.5f);
let _e1984 = (0.5f * (_e1694 + _e1979));
let _e1985 = (_e1982 + _e1984);
let _e1987 = (0.5f * (_e1981 + _e1985));
let _e1991 = bitcast<f32>((bitcast<u32>((_e1985 - _e1981)) & 2147483647u));
let _e1994 = (1f / select(0.0625f, _e1991, (_e1991 > 0.0625f)));
let _e1996 = ((-0.5f - _e1987) * _e1994);
let _e1998 = select(-0.5f, _e1996, (_e1996 > -0.5f));
let _e2000 = ((0.5f - _e1987) * _e1994);
let _e2002 = select(0.5f, _e2000, (_e2000 < 0.5f));
let _e2003 = (_e2002 - _e1998);
let _e2005 = select(0f, _e2003, (_e2003 > 0f));
let _e2007 = (0.5f * (_e1998 + _e2002));
let _e2013 = ((_e1683 && _e1733) && _e1735);
let _e2014 = (_e1738 + _e1643);
let _e2016 = select(_e88, _e2014, (_e2014 < _e88));
let _e2021 = global_4.member[bitcast<u32>(select(0i, _e2016, (_e2016 > 0i)))];
let _e2023 = (_e1748 + _e1643);
let _e2025 = select(_e88, _e2023, (_e2023 < _e88));
let _e2030 = global_4.member[bitcast<u32>(select(0i, _e2025, (_e2025 > 0i)))];
let _e2031 = select(_e1310, _e2030, _e1685);
let _e2033 = ((_e1683 && _e1758) && _e1760);
let _e2034 = (_e1763 + _e1643);
let _e2036 = select(_e88, _e2034, (_e2034 < _e88));
let _e2041 = global_4.member[bitcast<u32>(select(0i, _e2036, (_e2036 > 0i)))];
let _e2042 = select(_e1310, _e2041, _e2033);
let _e2045 = (_e1773 + (0.5f * (select(_e1310, _e2021, _e2013) + _e2031)));
let _e2047 = (0.5f * (_e2031 + _e2042));
let _e2048 = (_e1777 + _e2047);
let _e2050 = (0.5f * (_e2045 + _e2048));
let _e2054 = bitcast<f32>((bitcast<u32>((_e2048 - _e2045)) & 2147483647u));
let _e2057 = (1f / select(0.0625f, _e2054, (_e2054 > 0.0625f)));
let _e2059 = ((-0.5f - _e2050) * _e2057);
let _e2061 = select(-0.5f, _e2059, (_e2059 > -0.5f));
let _e2063 = ((0.5f - _e2050) * _e2057);
let _e2065 = select(0.5f, _e2063, (_e2063 < 0.5f));
let _e2066 = (_e2065 - _e2061);
let _e2068 = select(0f, _e2066, (_e2066 > 0f));
let _e2070 = (0.5f * (_e2061 + _e2065));
let _e2075 = (_e1808 + _e1965);
let _e2077 = select(_e185, _e2075, (_e2075 < _e185));
let _e2082 = global_3.member[bitcast<u32>(select(0i, _e2077, (_e2077 > 0i)))];
let _e2083 = select(_e1633, _e2082, _e1970);
let _e2084 = (_e1836 + _e1643);
let _e2086 = select(_e185, _e2084, (_e2084 < _e185));
let _e2091 = global_3.member[bitcast<u32>(select(0i, _e2086, (_e2086 > 0i)))];
let _e2093 = (_e1846 + _e1643);
let _e2095 = select(_e185, _e2093, (_e2093 < _e185));
let _e2100 = global_3.member[bitcast<u32>(select(0i, _e2095, (_e2095 > 0i)))];
let _e2101 = select(_e1633, _e2100, _e2033);
let _e2102 = (_e2083 - _e1835);
let _e2104 = (0.5f * (_e1857 + _e2102));
let _e2107 = bitcast<f32>((bitcast<u32>(_e2102) & 2147483647u));
let _e2110 = (2f * select(_e2107, _e1865, (_e1865 < _e2107)));
let _e2113 = bitcast<f32>((bitcast<u32>(_e2104) & 2147483647u));
let _e2115 = select(_e2110, _e2113, (_e2113 < _e2110));
let _e2123 = select(1e-20f, _e1835, (_e1835 > 1e-20f));
let _e2124 = (select(0f, select(_e2115, -(_e2115), (_e2104 < 0f)), ((_e1857 * _e2102) > 0f)) / _e2123);
let _e2126 = select(-1f, _e2124, (_e2124 > -1f));
let _e2129 = (_e1835 - select(_e1633, _e2091, _e2013));
let _e2130 = (_e2101 - _e1835);
let _e2132 = (0.5f * (_e2129 + _e2130));
let _e2135 = bitcast<f32>((bitcast<u32>(_e2129) & 2147483647u));
let _e2138 = bitcast<f32>((bitcast<u32>(_e2130) & 2147483647u));
let _e2141 = (2f * select(_e2138, _e2135, (_e2135 < _e2138)));
let _e2144 = bitcast<f32>((bitcast<u32>(_e2132) & 2147483647u));
let _e2146 = select(_e2141, _e2144, (_e2144 < _e2141));
let _e2153 = (select(0f, select(_e2146, -(_e2146), (_e2132 < 0f)), ((_e2129 * _e2130) > 0f)) / _e2123);
let _e2155 = select(-1f, _e2153, (_e2153 > -1f));
let _e2164 = ((_e2005 * _e2068) + (((select(1f, _e2126, (_e2126 < 1f)) * (_e2005 * select(_e2007, -(_e2007), (_e1985 < _e1981)))) * _e2068) + ((select(1f, _e2155, (_e2155 < 1f)) * _e2005) * (_e2068 * select(_e2070, -(_e2070), (_e2048 < _e2045))))));
let _e2166 = select(0f, _e2164, (_e2164 > 0f));
let _e2167 = (_e1655 + _e1643);
let _e2169 = select(_e185, _e2167, (_e2167 < _e185));
let _e2174 = global_3.member[bitcast<u32>(select(0i, _e2169, (_e2169 > 0i)))];
let _e2175 = select(_e1633, _e2174, _e1685);
if _e117 {
phi_4891_ = _e2175;
phi_4892_ = _e2175;
} else {
let _e2177 = ((_e1640 + _e1655) + _e1643);
let _e2179 = select(_e185, _e2177, (_e2177 < _e185));
let _e2184 = global_3.member[bitcast<u32>(select(0i, _e2179, (_e2179 > 0i)))];
let _e2187 = select(_e185, _e1686, (_e1686 < _e185));
let _e2192 = global_3.member[bitcast<u32>(select(0i, _e2187, (_e2187 > 0i)))];
phi_4891_ = select(_e1633, _e2192, _e1685);
phi_4892_ = select(_e1633, _e2184, _e1685);
}
let _e2195 = phi_4891_;
let _e2197 = phi_4892_;
let _e2207 = f32((_e1608 + 1i));
let _e2208 = (_e1643 + 2i);
let _e2211 = ((_e2208 >= 0i) && (_e2208 < _e1638));
let _e2213 = ((_e2211 && _e1651) && _e1653);
let _e2214 = (_e1656 + _e2208);
let _e2216 = select(_e88, _e2214, (_e2214 < _e88));
let _e2221 = global_4.member[bitcast<u32>(select(0i, _e2216, (_e2216 > 0i)))];
let _e2223 = (_e2207 - 0.5f);
let _e2224 = (_e2223 + _e1984);
let _e2225 = (_e2207 + 0.5f);
let _e2228 = (_e2225 + (0.5f * (_e1979 + select(_e1303, _e2221, _e2213))));
let _e2230 = (0.5f * (_e2224 + _e2228));
let _e2234 = bitcast<f32>((bitcast<u32>((_e2228 - _e2224)) & 2147483647u));
let _e2237 = (1f / select(0.0625f, _e2234, (_e2234 > 0.0625f)));
let _e2239 = ((-0.5f - _e2230) * _e2237);
let _e2241 = select(-0.5f, _e2239, (_e2239 > -0.5f));
let _e2243 = ((0.5f - _e2230) * _e2237);
let _e2245 = select(0.5f, _e2243, (_e2243 < 0.5f));
let _e2246 = (_e2245 - _e2241);
let _e2248 = select(0f, _e2246, (_e2246 > 0f));
let _e2250 = (0.5f * (_e2241 + _e2245));
let _e2256 = ((_e1968 && _e1733) && _e1735);
let _e2257 = (_e1738 + _e1965);
let _e2259 = select(_e88, _e2257, (_e2257 < _e88));
let _e2264 = global_4.member[bitcast<u32>(select(0i, _e2259, (_e2259 > 0i)))];
let _e2266 = (_e1748 + _e1965);
let _e2268 = select(_e88, _e2266, (_e2266 < _e88));
let _e2273 = global_4.member[bitcast<u32>(select(0i, _e2268, (_e2268 > 0i)))];
let _e2274 = select(_e1310, _e2273, _e1970);
let _e2276 = ((_e1968 && _e1758) && _e1760);
let _e2277 = (_e1763 + _e1965);
let _e2279 = select(_e88, _e2277, (_e2277 < _e88));
let _e2284 = global_4.member[bitcast<u32>(select(0i, _e2279, (_e2279 > 0i)))];
let _e2285 = select(_e1310, _e2284, _e2276);
let _e2288 = (_e1773 + (0.5f * (select(_e1310, _e2264, _e2256) + _e2274)));
let _e2290 = (0.5f * (_e2274 + _e2285));
let _e2291 = (_e1777 + _e2290);
let _e2293 = (0.5f * (_e2288 + _e2291));
let _e2297 = bitcast<f32>((bitcast<u32>((_e2291 - _e2288)) & 2147483647u));
let _e2300 = (1f / select(0.0625f, _e2297, (_e2297 > 0.0625f)));
let _e2302 = ((-0.5f - _e2293) * _e2300);
let _e2304 = select(-0.5f, _e2302, (_e2302 > -0.5f));
let _e2306 = ((0.5f - _e2293) * _e2300);
let _e2308 = select(0.5f, _e2306, (_e2306 < 0.5f));
let _e2309 = (_e2308 - _e2304);
let _e2311 = select(0f, _e2309, (_e2309 > 0f));
let _e2313 = (0.5f * (_e2304 + _e2308));
let _e2318 = (_e1808 + _e2208);
let _e2320 = select(_e185, _e2318, (_e2318 < _e185));
let _e2325 = global_3.member[bitcast<u32>(select(0i, _e2320, (_e2320 > 0i)))];
let _e2327 = (_e1836 + _e1965);
let _e2329 = select(_e185, _e2327, (_e2327 < _e185));
let _e2334 = global_3.member[bitcast<u32>(select(0i, _e2329, (_e2329 > 0i)))];
let _e2336 = (_e1846 + _e1965);
let _e2338 = select(_e185, _e2336, (_e2336 < _e185));
let _e2343 = global_3.member[bitcast<u32>(select(0i, _e2338, (_e2338 > 0i)))];
let _e2344 = select(_e1633, _e2343, _e2276);
let _e2345 = (select(_e1633, _e2325, _e2213) - _e2083);
let _e2347 = (0.5f * (_e2102 + _e2345));
let _e2350 = bitcast<f32>((bitcast<u32>(_e2345) & 2147483647u));
let _e2353 = (2f * select(_e2350, _e2107, (_e2107 < _e2350)));
let _e2356 = bitcast<f32>((bitcast<u32>(_e2347) & 2147483647u));
let _e2358 = select(_e2353, _e2356, (_e2356 < _e2353));
let _e2366 = select(1e-20f, _e2083, (_e2083 > 1e-20f));
let _e2367 = (select(0f, select(_e2358, -(_e2358), (_e2347 < 0f)), ((_e2102 * _e2345) > 0f)) / _e2366);
let _e2369 = select(-1f, _e2367, (_e2367 > -1f));
let _e2372 = (_e2083 - select(_e1633, _e2334, _e2256));
let _e2373 = (_e2344 - _e2083);
let _e2375 = (0.5f * (_e2372 + _e2373));
let _e2378 = bitcast<f32>((bitcast<u32>(_e2372) & 2147483647u));
let _e2381 = bitcast<f32>((bitcast<u32>(_e2373) & 2147483647u));
let _e2384 = (2f * select(_e2381, _e2378, (_e2378 < _e2381)));
let _e2387 = bitcast<f32>((bitcast<u32>(_e2375) & 2147483647u));
let _e2389 = select(_e2384, _e2387, (_e2387 < _e2384));
let _e2396 = (select(0f, select(_e2389, -(_e2389), (_e2375 < 0f)), ((_e2372 * _e2373) > 0f)) / _e2366);
let _e2398 = select(-1f, _e2396, (_e2396 > -1f));
let _e2407 = ((_e2248 * _e2311) + (((select(1f, _e2369, (_e2369 < 1f)) * (_e2248 * select(_e2250, -(_e2250), (_e2228 < _e2224)))) * _e2311) + ((select(1f, _e2398, (_e2398 < 1f)) * _e2248) * (_e2311 * select(_e2313, -(_e2313), (_e2291 < _e2288))))));
let _e2409 = select(0f, _e2407, (_e2407 > 0f));
let _e2410 = (_e1655 + _e1965);
let _e2412 = select(_e185, _e2410, (_e2410 < _e185));
let _e2417 = global_3.member[bitcast<u32>(select(0i, _e2412, (_e2412 > 0i)))];
let _e2418 = select(_e1633, _e2417, _e1970);
if _e117 {
phi_5814_ = _e2418;
phi_5815_ = _e2418;
} else {
let _e2420 = ((_e1640 + _e1655) + _e1965);
let _e2422 = select(_e185, _e2420, (_e2420 < _e185));
let _e2427 = global_3.member[bitcast<u32>(select(0i, _e2422, (_e2422 > 0i)))];
let _e2430 = select(_e185, _e1971, (_e1971 < _e185));
let _e2435 = global_3.member[bitcast<u32>(select(0i, _e2430, (_e2430 > 0i)))];
phi_5814_ = select(_e1633, _e2435, _e1970);
phi_5815_ = select(_e1633, _e2427, _e1970);
}
let _e2438 = phi_5814_;
let _e2440 = phi_5815_;
let _e2450 = ((_e1650 && _e1758) && _e1760);
let _e2451 = (_e1641 + _e1762);
let _e2452 = (_e2451 + _e1644);
let _e2454 = select(_e88, _e2452, (_e2452 < _e88));
let _e2459 = global_4.member[bitcast<u32>(select(0i, _e2454, (_e2454 > 0i)))];
let _e2461 = (_e2451 + _e1666);
let _e2463 = select(_e88, _e2461, (_e2461 < _e88));
let _e2468 = global_4.member[bitcast<u32>(select(0i, _e2463, (_e2463 > 0i)))];
let _e2469 = select(_e1303, _e2468, _e1761);
let _e2470 = (_e2451 + _e1643);
let _e2472 = select(_e88, _e2470, (_e2470 < _e88));
let _e2477 = global_4.member[bitcast<u32>(select(0i, _e2472, (_e2472 > 0i)))];
let _e2478 = select(_e1303, _e2477, _e2033);
let _e2481 = (_e1695 + (0.5f * (select(_e1303, _e2459, _e2450) + _e2469)));
let _e2483 = (0.5f * (_e2469 + _e2478));
let _e2484 = (_e1699 + _e2483);
let _e2486 = (0.5f * (_e2481 + _e2484));
let _e2490 = bitcast<f32>((bitcast<u32>((_e2484 - _e2481)) & 2147483647u));
let _e2493 = (1f / select(0.0625f, _e2490, (_e2490 > 0.0625f)));
let _e2495 = ((-0.5f - _e2486) * _e2493);
let _e2497 = select(-0.5f, _e2495, (_e2495 > -0.5f));
let _e2499 = ((0.5f - _e2486) * _e2493);
let _e2501 = select(0.5f, _e2499, (_e2499 < 0.5f));
let _e2502 = (_e2501 - _e2497);
let _e2504 = select(0f, _e2502, (_e2502 > 0f));
let _e2506 = (0.5f * (_e2497 + _e2501));
let _e2511 = f32(_e1629);
let _e2512 = (_e1646 + 1i);
let _e2513 = (_e2512 >= 0i);
let _e2515 = (_e2512 < _e1639);
let _e2516 = ((_e1669 && _e2513) && _e2515);
let _e2517 = (_e2512 * _e1638);
let _e2518 = (_e1731 + _e2517);
let _e2519 = (_e2518 + _e1666);
let _e2521 = select(_e88, _e2519, (_e2519 < _e88));
let _e2526 = global_4.member[bitcast<u32>(select(0i, _e2521, (_e2521 > 0i)))];
let _e2527 = select(_e1310, _e2526, _e2516);
let _e2528 = (_e2511 - 0.5f);
let _e2529 = (_e2528 + _e1779);
let _e2530 = (_e2511 + 0.5f);
let _e2532 = (0.5f * (_e1772 + _e2527));
let _e2533 = (_e2530 + _e2532);
let _e2535 = (0.5f * (_e2529 + _e2533));
let _e2539 = bitcast<f32>((bitcast<u32>((_e2533 - _e2529)) & 2147483647u));
let _e2542 = (1f / select(0.0625f, _e2539, (_e2539 > 0.0625f)));
let _e2544 = ((-0.5f - _e2535) * _e2542);
let _e2546 = select(-0.5f, _e2544, (_e2544 > -0.5f));
let _e2548 = ((0.5f - _e2535) * _e2542);
let _e2550 = select(0.5f, _e2548, (_e2548 < 0.5f));
let _e2551 = (_e2550 - _e2546);
let _e2553 = select(0f, _e2551, (_e2551 > 0f));
let _e2555 = (0.5f * (_e2546 + _e2550));
let _e2560 = (_e1846 + _e1644);
let _e2562 = select(_e185, _e2560, (_e2560 < _e185));
let _e2567 = global_3.member[bitcast<u32>(select(0i, _e2562, (_e2562 > 0i)))];
let _e2569 = (_e1807 + _e2517);
let _e2570 = (_e2569 + _e1666);
let _e2572 = select(_e185, _e2570, (_e2570 < _e185));
let _e2577 = global_3.member[bitcast<u32>(select(0i, _e2572, (_e2572 > 0i)))];
let _e2578 = select(_e1633, _e2577, _e2516);
let _e2579 = (_e1855 - select(_e1633, _e2567, _e2450));
let _e2580 = (_e2101 - _e1855);
let _e2582 = (0.5f * (_e2579 + _e2580));
let _e2585 = bitcast<f32>((bitcast<u32>(_e2579) & 2147483647u));
let _e2588 = bitcast<f32>((bitcast<u32>(_e2580) & 2147483647u));
let _e2591 = (2f * select(_e2588, _e2585, (_e2585 < _e2588)));
let _e2594 = bitcast<f32>((bitcast<u32>(_e2582) & 2147483647u));
let _e2596 = select(_e2591, _e2594, (_e2594 < _e2591));
let _e2604 = select(1e-20f, _e1855, (_e1855 > 1e-20f));
let _e2605 = (select(0f, select(_e2596, -(_e2596), (_e2582 < 0f)), ((_e2579 * _e2580) > 0f)) / _e2604);
let _e2607 = select(-1f, _e2605, (_e2605 > -1f));
let _e2610 = (_e2578 - _e1855);
let _e2612 = (0.5f * (_e1888 + _e2610));
let _e2615 = bitcast<f32>((bitcast<u32>(_e2610) & 2147483647u));
let _e2618 = (2f * select(_e2615, _e1896, (_e1896 < _e2615)));
let _e2621 = bitcast<f32>((bitcast<u32>(_e2612) & 2147483647u));
let _e2623 = select(_e2618, _e2621, (_e2621 < _e2618));
let _e2630 = (select(0f, select(_e2623, -(_e2623), (_e2612 < 0f)), ((_e1888 * _e2610) > 0f)) / _e2604);
let _e2632 = select(-1f, _e2630, (_e2630 > -1f));
let _e2641 = ((_e2504 * _e2553) + (((select(1f, _e2607, (_e2607 < 1f)) * (_e2504 * select(_e2506, -(_e2506), (_e2484 < _e2481)))) * _e2553) + ((select(1f, _e2632, (_e2632 < 1f)) * _e2504) * (_e2553 * select(_e2555, -(_e2555), (_e2533 < _e2529))))));
let _e2643 = select(0f, _e2641, (_e2641 > 0f));
let _e2644 = (_e1762 + _e1666);
let _e2646 = select(_e185, _e2644, (_e2644 < _e185));
let _e2651 = global_3.member[bitcast<u32>(select(0i, _e2646, (_e2646 > 0i)))];
let _e2652 = select(_e1633, _e2651, _e1761);
if _e117 {
phi_6737_ = _e2652;
phi_6738_ = _e2652;
} else {
let _e2654 = ((_e1640 + _e1762) + _e1666);
let _e2656 = select(_e185, _e2654, (_e2654 < _e185));
let _e2661 = global_3.member[bitcast<u32>(select(0i, _e2656, (_e2656 > 0i)))];
let _e2664 = select(_e185, _e2461, (_e2461 < _e185));
let _e2669 = global_3.member[bitcast<u32>(select(0i, _e2664, (_e2664 > 0i)))];
phi_6737_ = select(_e1633, _e2669, _e1761);
phi_6738_ = select(_e1633, _e2661, _e1761);
}
let _e2672 = phi_6737_;
let _e2674 = phi_6738_;
let _e2683 = (_e2451 + _e1965);
let _e2685 = select(_e88, _e2683, (_e2683 < _e88));
let _e2690 = global_4.member[bitcast<u32>(select(0i, _e2685, (_e2685 > 0i)))];
let _e2691 = select(_e1303, _e2690, _e2276);
let _e2692 = (_e1980 + _e2483);
let _e2694 = (0.5f * (_e2478 + _e2691));
let _e2695 = (_e1982 + _e2694);
let _e2697 = (0.5f * (_e2692 + _e2695));
let _e2701 = bitcast<f32>((bitcast<u32>((_e2695 - _e2692)) & 2147483647u));
let _e2704 = (1f / select(0.0625f, _e2701, (_e2701 > 0.0625f)));
let _e2706 = ((-0.5f - _e2697) * _e2704);
let _e2708 = select(-0.5f, _e2706, (_e2706 > -0.5f));
let _e2710 = ((0.5f - _e2697) * _e2704);
let _e2712 = select(0.5f, _e2710, (_e2710 < 0.5f));
let _e2713 = (_e2712 - _e2708);
let _e2715 = select(0f, _e2713, (_e2713 > 0f));
let _e2717 = (0.5f * (_e2708 + _e2712));
let _e2723 = ((_e1683 && _e2513) && _e2515);
let _e2724 = (_e2518 + _e1643);
let _e2726 = select(_e88, _e2724, (_e2724 < _e88));
let _e2731 = global_4.member[bitcast<u32>(select(0i, _e2726, (_e2726 > 0i)))];
let _e2732 = select(_e1310, _e2731, _e2723);
let _e2733 = (_e2528 + _e2047);
let _e2735 = (0.5f * (_e2042 + _e2732));
let _e2736 = (_e2530 + _e2735);
let _e2738 = (0.5f * (_e2733 + _e2736));
let _e2742 = bitcast<f32>((bitcast<u32>((_e2736 - _e2733)) & 2147483647u));
let _e2745 = (1f / select(0.0625f, _e2742, (_e2742 > 0.0625f)));
let _e2747 = ((-0.5f - _e2738) * _e2745);
let _e2749 = select(-0.5f, _e2747, (_e2747 > -0.5f));
let _e2751 = ((0.5f - _e2738) * _e2745);
let _e2753 = select(0.5f, _e2751, (_e2751 < 0.5f));
let _e2754 = (_e2753 - _e2749);
let _e2756 = select(0f, _e2754, (_e2754 > 0f));
let _e2758 = (0.5f * (_e2749 + _e2753));
let _e2763 = (_e2569 + _e1643);
let _e2765 = select(_e185, _e2763, (_e2763 < _e185));
let _e2770 = global_3.member[bitcast<u32>(select(0i, _e2765, (_e2765 > 0i)))];
let _e2771 = select(_e1633, _e2770, _e2723);
let _e2772 = (_e2344 - _e2101);
let _e2774 = (0.5f * (_e2580 + _e2772));
let _e2777 = bitcast<f32>((bitcast<u32>(_e2772) & 2147483647u));
let _e2780 = (2f * select(_e2777, _e2588, (_e2588 < _e2777)));
let _e2783 = bitcast<f32>((bitcast<u32>(_e2774) & 2147483647u));
let _e2785 = select(_e2780, _e2783, (_e2783 < _e2780));
let _e2793 = select(1e-20f, _e2101, (_e2101 > 1e-20f));
let _e2794 = (select(0f, select(_e2785, -(_e2785), (_e2774 < 0f)), ((_e2580 * _e2772) > 0f)) / _e2793);
let _e2796 = select(-1f, _e2794, (_e2794 > -1f));
let _e2799 = (_e2771 - _e2101);
let _e2801 = (0.5f * (_e2130 + _e2799));
let _e2804 = bitcast<f32>((bitcast<u32>(_e2799) & 2147483647u));
let _e2807 = (2f * select(_e2804, _e2138, (_e2138 < _e2804)));
let _e2810 = bitcast<f32>((bitcast<u32>(_e2801) & 2147483647u));
let _e2812 = select(_e2807, _e2810, (_e2810 < _e2807));
let _e2819 = (select(0f, select(_e2812, -(_e2812), (_e2801 < 0f)), ((_e2130 * _e2799) > 0f)) / _e2793);
let _e2821 = select(-1f, _e2819, (_e2819 > -1f));
let _e2830 = ((_e2715 * _e2756) + (((select(1f, _e2796, (_e2796 < 1f)) * (_e2715 * select(_e2717, -(_e2717), (_e2695 < _e2692)))) * _e2756) + ((select(1f, _e2821, (_e2821 < 1f)) * _e2715) * (_e2756 * select(_e2758, -(_e2758), (_e2736 < _e2733))))));
let _e2832 = select(0f, _e2830, (_e2830 > 0f));
let _e2833 = (_e1762 + _e1643);
let _e2835 = select(_e185, _e2833, (_e2833 < _e185));
let _e2840 = global_3.member[bitcast<u32>(select(0i, _e2835, (_e2835 > 0i)))];
let _e2841 = select(_e1633, _e2840, _e2033);
if _e117 {
phi_7660_ = _e2841;
phi_7661_ = _e2841;
} else {
let _e2843 = ((_e1640 + _e1762) + _e1643);
let _e2845 = select(_e185, _e2843, (_e2843 < _e185));
let _e2850 = global_3.member[bitcast<u32>(select(0i, _e2845, (_e2845 > 0i)))];
let _e2853 = select(_e185, _e2470, (_e2470 < _e185));
let _e2858 = global_3.member[bitcast<u32>(select(0i, _e2853, (_e2853 > 0i)))];
phi_7660_ = select(_e1633, _e2858, _e2033);
phi_7661_ = select(_e1633, _e2850, _e2033);
}
let _e2861 = phi_7660_;
let _e2863 = phi_7661_;
let _e2873 = ((_e2211 && _e1758) && _e1760);
let _e2874 = (_e2451 + _e2208);
let _e2876 = select(_e88, _e2874, (_e2874 < _e88));
let _e2881 = global_4.member[bitcast<u32>(select(0i, _e2876, (_e2876 > 0i)))];
let _e2883 = (_e2223 + _e2694);
let _e2886 = (_e2225 + (0.5f * (_e2691 + select(_e1303, _e2881, _e2873))));
let _e2888 = (0.5f * (_e2883 + _e2886));
let _e2892 = bitcast<f32>((bitcast<u32>((_e2886 - _e2883)) & 2147483647u));
let _e2895 = (1f / select(0.0625f, _e2892, (_e2892 > 0.0625f)));
let _e2897 = ((-0.5f - _e2888) * _e2895);
let _e2899 = select(-0.5f, _e2897, (_e2897 > -0.5f));
let _e2901 = ((0.5f - _e2888) * _e2895);
let _e2903 = select(0.5f, _e2901, (_e2901 < 0.5f));
let _e2904 = (_e2903 - _e2899);
let _e2906 = select(0f, _e2904, (_e2904 > 0f));
let _e2908 = (0.5f * (_e2899 + _e2903));
let _e2914 = ((_e1968 && _e2513) && _e2515);
let _e2915 = (_e2518 + _e1965);
let _e2917 = select(_e88, _e2915, (_e2915 < _e88));
let _e2922 = global_4.member[bitcast<u32>(select(0i, _e2917, (_e2917 > 0i)))];
let _e2923 = select(_e1310, _e2922, _e2914);
let _e2924 = (_e2528 + _e2290);
let _e2926 = (0.5f * (_e2285 + _e2923));
let _e2927 = (_e2530 + _e2926);
let _e2929 = (0.5f * (_e2924 + _e2927));
let _e2933 = bitcast<f32>((bitcast<u32>((_e2927 - _e2924)) & 2147483647u));
let _e2936 = (1f / select(0.0625f, _e2933, (_e2933 > 0.0625f)));
let _e2938 = ((-0.5f - _e2929) * _e2936);
let _e2940 = select(-0.5f, _e2938, (_e2938 > -0.5f));
let _e2942 = ((0.5f - _e2929) * _e2936);
let _e2944 = select(0.5f, _e2942, (_e2942 < 0.5f));
let _e2945 = (_e2944 - _e2940);
let _e2947 = select(0f, _e2945, (_e2945 > 0f));
let _e2949 = (0.5f * (_e2940 + _e2944));
let _e2954 = (_e1846 + _e2208);
let _e2956 = select(_e185, _e2954, (_e2954 < _e185));
let _e2961 = global_3.member[bitcast<u32>(select(0i, _e2956, (_e2956 > 0i)))];
let _e2963 = (_e2569 + _e1965);
let _e2965 = select(_e185, _e2963, (_e2963 < _e185));
let _e2970 = global_3.member[bitcast<u32>(select(0i, _e2965, (_e2965 > 0i)))];
let _e2971 = select(_e1633, _e2970, _e2914);
let _e2972 = (select(_e1633, _e2961, _e2873) - _e2344);
let _e2974 = (0.5f * (_e2772 + _e2972));
let _e2977 = bitcast<f32>((bitcast<u32>(_e2972) & 2147483647u));
let _e2980 = (2f * select(_e2977, _e2777, (_e2777 < _e2977)));
let _e2983 = bitcast<f32>((bitcast<u32>(_e2974) & 2147483647u));
let _e2985 = select(_e2980, _e2983, (_e2983 < _e2980));
let _e2993 = select(1e-20f, _e2344, (_e2344 > 1e-20f));
let _e2994 = (select(0f, select(_e2985, -(_e2985), (_e2974 < 0f)), ((_e2772 * _e2972) > 0f)) / _e2993);
let _e2996 = select(-1f, _e2994, (_e2994 > -1f));
let _e2999 = (_e2971 - _e2344);
let _e3001 = (0.5f * (_e2373 + _e2999));
let _e3004 = bitcast<f32>((bitcast<u32>(_e2999) & 2147483647u));
let _e3007 = (2f * select(_e3004, _e2381, (_e2381 < _e3004)));
let _e3010 = bitcast<f32>((bitcast<u32>(_e3001) & 2147483647u));
let _e3012 = select(_e3007, _e3010, (_e3010 < _e3007));
let _e3019 = (select(0f, select(_e3012, -(_e3012), (_e3001 < 0f)), ((_e2373 * _e2999) > 0f)) / _e2993);
let _e3021 = select(-1f, _e3019, (_e3019 > -1f));
let _e3030 = ((_e2906 * _e2947) + (((select(1f, _e2996, (_e2996 < 1f)) * (_e2906 * select(_e2908, -(_e2908), (_e2886 < _e2883)))) * _e2947) + ((select(1f, _e3021, (_e3021 < 1f)) * _e2906) * (_e2947 * select(_e2949, -(_e2949), (_e2927 < _e2924))))));
let _e3032 = select(0f, _e3030, (_e3030 > 0f));
let _e3033 = (_e1762 + _e1965);
let _e3035 = select(_e185, _e3033, (_e3033 < _e185));
let _e3040 = global_3.member[bitcast<u32>(select(0i, _e3035, (_e3035 > 0i)))];
let _e3041 = select(_e1633, _e3040, _e2276);
if _e117 {
phi_8583_ = _e3041;
phi_8584_ = _e3041;
} else {
let _e3043 = ((_e1640 + _e1762) + _e1965);
let _e3045 = select(_e185, _e3043, (_e3043 < _e185));
let _e3050 = global_3.member[bitcast<u32>(select(0i, _e3045, (_e3045 > 0i)))];
let _e3053 = select(_e185, _e2683, (_e2683 < _e185));
let _e3058 = global_3.member[bitcast<u32>(select(0i, _e3053, (_e3053 > 0i)))];
phi_8583_ = select(_e1633, _e3058, _e2276);
phi_8584_ = select(_e1633, _e3050, _e2276);
}
let _e3061 = phi_8583_;
let _e3063 = phi_8584_;
let _e3073 = ((_e1650 && _e2513) && _e2515);
let _e3074 = (_e1641 + _e2517);
let _e3075 = (_e3074 + _e1644);
let _e3077 = select(_e88, _e3075, (_e3075 < _e88));
let _e3082 = global_4.member[bitcast<u32>(select(0i, _e3077, (_e3077 > 0i)))];
let _e3084 = (_e3074 + _e1666);
let _e3086 = select(_e88, _e3084, (_e3084 < _e88));
let _e3091 = global_4.member[bitcast<u32>(select(0i, _e3086, (_e3086 > 0i)))];
let _e3092 = select(_e1303, _e3091, _e2516);
let _e3093 = (_e3074 + _e1643);
let _e3095 = select(_e88, _e3093, (_e3093 < _e88));
let _e3100 = global_4.member[bitcast<u32>(select(0i, _e3095, (_e3095 > 0i)))];
let _e3101 = select(_e1303, _e3100, _e2723);
let _e3104 = (_e1695 + (0.5f * (select(_e1303, _e3082, _e3073) + _e3092)));
let _e3106 = (0.5f * (_e3092 + _e3101));
let _e3107 = (_e1699 + _e3106);
let _e3109 = (0.5f * (_e3104 + _e3107));
let _e3113 = bitcast<f32>((bitcast<u32>((_e3107 - _e3104)) & 2147483647u));
let _e3116 = (1f / select(0.0625f, _e3113, (_e3113 > 0.0625f)));
let _e3118 = ((-0.5f - _e3109) * _e3116);
let _e3120 = select(-0.5f, _e3118, (_e3118 > -0.5f));
let _e3122 = ((0.5f - _e3109) * _e3116);
let _e3124 = select(0.5f, _e3122, (_e3122 < 0.5f));
let _e3125 = (_e3124 - _e3120);
let _e3127 = select(0f, _e3125, (_e3125 > 0f));
let _e3129 = (0.5f * (_e3120 + _e3124));
let _e3135 = f32((_e1629 + 1i));
let _e3136 = (_e1646 + 2i);
let _e3137 = (_e3136 >= 0i);
let _e3139 = (_e3136 < _e1639);
let _e3140 = ((_e1669 && _e3137) && _e3139);
let _e3141 = (_e3136 * _e1638);
let _e3142 = (_e1731 + _e3141);
let _e3143 = (_e3142 + _e1666);
let _e3145 = select(_e88, _e3143, (_e3143 < _e88));
let _e3150 = global_4.member[bitcast<u32>(select(0i, _e3145, (_e3145 > 0i)))];
let _e3152 = (_e3135 - 0.5f);
let _e3153 = (_e3152 + _e2532);
let _e3154 = (_e3135 + 0.5f);
let _e3157 = (_e3154 + (0.5f * (_e2527 + select(_e1310, _e3150, _e3140))));
let _e3159 = (0.5f * (_e3153 + _e3157));
let _e3163 = bitcast<f32>((bitcast<u32>((_e3157 - _e3153)) & 2147483647u));
let _e3166 = (1f / select(0.0625f, _e3163, (_e3163 > 0.0625f)));
let _e3168 = ((-0.5f - _e3159) * _e3166);
let _e3170 = select(-0.5f, _e3168, (_e3168 > -0.5f));
let _e3172 = ((0.5f - _e3159) * _e3166);
let _e3174 = select(0.5f, _e3172, (_e3172 < 0.5f));
let _e3175 = (_e3174 - _e3170);
let _e3177 = select(0f, _e3175, (_e3175 > 0f));
let _e3179 = (0.5f * (_e3170 + _e3174));
let _e3184 = (_e2569 + _e1644);
let _e3186 = select(_e185, _e3184, (_e3184 < _e185));
let _e3191 = global_3.member[bitcast<u32>(select(0i, _e3186, (_e3186 > 0i)))];
let _e3193 = (_e1807 + _e3141);
let _e3194 = (_e3193 + _e1666);
let _e3196 = select(_e185, _e3194, (_e3194 < _e185));
let _e3201 = global_3.member[bitcast<u32>(select(0i, _e3196, (_e3196 > 0i)))];
let _e3203 = (_e2578 - select(_e1633, _e3191, _e3073));
let _e3204 = (_e2771 - _e2578);
let _e3206 = (0.5f * (_e3203 + _e3204));
let _e3209 = bitcast<f32>((bitcast<u32>(_e3203) & 2147483647u));
let _e3212 = bitcast<f32>((bitcast<u32>(_e3204) & 2147483647u));
let _e3215 = (2f * select(_e3212, _e3209, (_e3209 < _e3212)));
let _e3218 = bitcast<f32>((bitcast<u32>(_e3206) & 2147483647u));
let _e3220 = select(_e3215, _e3218, (_e3218 < _e3215));
let _e3228 = select(1e-20f, _e2578, (_e2578 > 1e-20f));
let _e3229 = (select(0f, select(_e3220, -(_e3220), (_e3206 < 0f)), ((_e3203 * _e3204) > 0f)) / _e3228);
let _e3231 = select(-1f, _e3229, (_e3229 > -1f));
let _e3234 = (select(_e1633, _e3201, _e3140) - _e2578);
let _e3236 = (0.5f * (_e2610 + _e3234));
let _e3239 = bitcast<f32>((bitcast<u32>(_e3234) & 2147483647u));
let _e3242 = (2f * select(_e3239, _e2615, (_e2615 < _e3239)));
let _e3245 = bitcast<f32>((bitcast<u32>(_e3236) & 2147483647u));
let _e3247 = select(_e3242, _e3245, (_e3245 < _e3242));
let _e3254 = (select(0f, select(_e3247, -(_e3247), (_e3236 < 0f)), ((_e2610 * _e3234) > 0f)) / _e3228);
let _e3256 = select(-1f, _e3254, (_e3254 > -1f));
let _e3265 = ((_e3127 * _e3177) + (((select(1f, _e3231, (_e3231 < 1f)) * (_e3127 * select(_e3129, -(_e3129), (_e3107 < _e3104)))) * _e3177) + ((select(1f, _e3256, (_e3256 < 1f)) * _e3127) * (_e3177 * select(_e3179, -(_e3179), (_e3157 < _e3153))))));
let _e3267 = select(0f, _e3265, (_e3265 > 0f));
let _e3268 = (_e2517 + _e1666);
let _e3270 = select(_e185, _e3268, (_e3268 < _e185));
let _e3275 = global_3.member[bitcast<u32>(select(0i, _e3270, (_e3270 > 0i)))];
let _e3276 = select(_e1633, _e3275, _e2516);
if _e117 {
phi_9506_ = _e3276;
phi_9507_ = _e3276;
} else {
let _e3278 = ((_e1640 + _e2517) + _e1666);
let _e3280 = select(_e185, _e3278, (_e3278 < _e185));
let _e3285 = global_3.member[bitcast<u32>(select(0i, _e3280, (_e3280 > 0i)))];
let _e3288 = select(_e185, _e3084, (_e3084 < _e185));
let _e3293 = global_3.member[bitcast<u32>(select(0i, _e3288, (_e3288 > 0i)))];
phi_9506_ = select(_e1633, _e3293, _e2516);
phi_9507_ = select(_e1633, _e3285, _e2516);
}
let _e3296 = phi_9506_;
let _e3298 = phi_9507_;
let _e3307 = (_e3074 + _e1965);
let _e3309 = select(_e88, _e3307, (_e3307 < _e88));
let _e3314 = global_4.member[bitcast<u32>(select(0i, _e3309, (_e3309 > 0i)))];
let _e3315 = select(_e1303, _e3314, _e2914);
let _e3316 = (_e1980 + _e3106);
let _e3318 = (0.5f * (_e3101 + _e3315));
let _e3319 = (_e1982 + _e3318);
let _e3321 = (0.5f * (_e3316 + _e3319));
let _e3325 = bitcast<f32>((bitcast<u32>((_e3319 - _e3316)) & 2147483647u));
let _e3328 = (1f / select(0.0625f, _e3325, (_e3325 > 0.0625f)));
let _e3330 = ((-0.5f - _e3321) * _e3328);
let _e3332 = select(-0.5f, _e3330, (_e3330 > -0.5f));
let _e3334 = ((0.5f - _e3321) * _e3328);
let _e3336 = select(0.5f, _e3334, (_e3334 < 0.5f));
let _e3337 = (_e3336 - _e3332);
let _e3339 = select(0f, _e3337, (_e3337 > 0f));
let _e3341 = (0.5f * (_e3332 + _e3336));
let _e3347 = ((_e1683 && _e3137) && _e3139);
let _e3348 = (_e3142 + _e1643);
let _e3350 = select(_e88, _e3348, (_e3348 < _e88));
let _e3355 = global_4.member[bitcast<u32>(select(0i, _e3350, (_e3350 > 0i)))];
let _e3357 = (_e3152 + _e2735);
let _e3360 = (_e3154 + (0.5f * (_e2732 + select(_e1310, _e3355, _e3347))));
let _e3362 = (0.5f * (_e3357 + _e3360));
let _e3366 = bitcast<f32>((bitcast<u32>((_e3360 - _e3357)) & 2147483647u));
let _e3369 = (1f / select(0.0625f, _e3366, (_e3366 > 0.0625f)));
let _e3371 = ((-0.5f - _e3362) * _e3369);
let _e3373 = select(-0.5f, _e3371, (_e3371 > -0.5f));
let _e3375 = ((0.5f - _e3362) * _e3369);
let _e3377 = select(0.5f, _e3375, (_e3375 < 0.5f));
let _e3378 = (_e3377 - _e3373);
let _e3380 = select(0f, _e3378, (_e3378 > 0f));
let _e3382 = (0.5f * (_e3373 + _e3377));
let _e3387 = (_e3193 + _e1643);
let _e3389 = select(_e185, _e3387, (_e3387 < _e185));
let _e3394 = global_3.member[bitcast<u32>(select(0i, _e3389, (_e3389 > 0i)))];
let _e3396 = (_e2971 - _e2771);
let _e3398 = (0.5f * (_e3204 + _e3396));
let _e3401 = bitcast<f32>((bitcast<u32>(_e3396) & 2147483647u));
let _e3404 = (2f * select(_e3401, _e3212, (_e3212 < _e3401)));
let _e3407 = bitcast<f32>((bitcast<u32>(_e3398) & 2147483647u));
let _e3409 = select(_e3404, _e3407, (_e3407 < _e3404));
let _e3417 = select(1e-20f, _e2771, (_e2771 > 1e-20f));
let _e3418 = (select(0f, select(_e3409, -(_e3409), (_e3398 < 0f)), ((_e3204 * _e3396) > 0f)) / _e3417);
let _e3420 = select(-1f, _e3418, (_e3418 > -1f));
let _e3423 = (select(_e1633, _e3394, _e3347) - _e2771);
let _e3425 = (0.5f * (_e2799 + _e3423));
let _e3428 = bitcast<f32>((bitcast<u32>(_e3423) & 2147483647u));
let _e3431 = (2f * select(_e3428, _e2804, (_e2804 < _e3428)));
let _e3434 = bitcast<f32>((bitcast<u32>(_e3425) & 2147483647u));
let _e3436 = select(_e3431, _e3434, (_e3434 < _e3431));
let _e3443 = (select(0f, select(_e3436, -(_e3436), (_e3425 < 0f)), ((_e2799 * _e3423) > 0f)) / _e3417);
let _e3445 = select(-1f, _e3443, (_e3443 > -1f));
let _e3454 = ((_e3339 * _e3380) + (((select(1f, _e3420, (_e3420 < 1f)) * (_e3339 * select(_e3341, -(_e3341), (_e3319 < _e3316)))) * _e3380) + ((select(1f, _e3445, (_e3445 < 1f)) * _e3339) * (_e3380 * select(_e3382, -(_e3382), (_e3360 < _e3357))))));
let _e3456 = select(0f, _e3454, (_e3454 > 0f));
let _e3457 = (_e2517 + _e1643);
let _e3459 = select(_e185, _e3457, (_e3457 < _e185));
let _e3464 = global_3.member[bitcast<u32>(select(0i, _e3459, (_e3459 > 0i)))];
let _e3465 = select(_e1633, _e3464, _e2723);
if _e117 {
phi_10429_ = _e3465;
phi_10430_ = _e3465;
} else {
let _e3467 = ((_e1640 + _e2517) + _e1643);
let _e3469 = select(_e185, _e3467, (_e3467 < _e185));
let _e3474 = global_3.member[bitcast<u32>(select(0i, _e3469, (_e3469 > 0i)))];
let _e3477 = select(_e185, _e3093, (_e3093 < _e185));
let _e3482 = global_3.member[bitcast<u32>(select(0i, _e3477, (_e3477 > 0i)))];
phi_10429_ = select(_e1633, _e3482, _e2723);
phi_10430_ = select(_e1633, _e3474, _e2723);
}
let _e3485 = phi_10429_;
let _e3487 = phi_10430_;
let _e3497 = ((_e2211 && _e2513) && _e2515);
let _e3498 = (_e3074 + _e2208);
let _e3500 = select(_e88, _e3498, (_e3498 < _e88));
let _e3505 = global_4.member[bitcast<u32>(select(0i, _e3500, (_e3500 > 0i)))];
let _e3507 = (_e2223 + _e3318);
let _e3510 = (_e2225 + (0.5f * (_e3315 + select(_e1303, _e3505, _e3497))));
let _e3512 = (0.5f * (_e3507 + _e3510));
let _e3516 = bitcast<f32>((bitcast<u32>((_e3510 - _e3507)) & 2147483647u));
let _e3519 = (1f / select(0.0625f, _e3516, (_e3516 > 0.0625f)));
let _e3521 = ((-0.5f - _e3512) * _e3519);
let _e3523 = select(-0.5f, _e3521, (_e3521 > -0.5f));
let _e3525 = ((0.5f - _e3512) * _e3519);
let _e3527 = select(0.5f, _e3525, (_e3525 < 0.5f));
let _e3528 = (_e3527 - _e3523);
let _e3530 = select(0f, _e3528, (_e3528 > 0f));
let _e3532 = (0.5f * (_e3523 + _e3527));
let _e3538 = ((_e1968 && _e3137) && _e3139);
let _e3539 = (_e3142 + _e1965);
let _e3541 = select(_e88, _e3539, (_e3539 < _e88));
let _e3546 = global_4.member[bitcast<u32>(select(0i, _e3541, (_e3541 > 0i)))];
let _e3548 = (_e3152 + _e2926);
let _e3551 = (_e3154 + (0.5f * (_e2923 + select(_e1310, _e3546, _e3538))));
let _e3553 = (0.5f * (_e3548 + _e3551));
let _e3557 = bitcast<f32>((bitcast<u32>((_e3551 - _e3548)) & 2147483647u));
let _e3560 = (1f / select(0.0625f, _e3557, (_e3557 > 0.0625f)));
let _e3562 = ((-0.5f - _e3553) * _e3560);
let _e3564 = select(-0.5f, _e3562, (_e3562 > -0.5f));
let _e3566 = ((0.5f - _e3553) * _e3560);
let _e3568 = select(0.5f, _e3566, (_e3566 < 0.5f));
let _e3569 = (_e3568 - _e3564);
let _e3571 = select(0f, _e3569, (_e3569 > 0f));
let _e3573 = (0.5f * (_e3564 + _e3568));
let _e3578 = (_e2569 + _e2208);
let _e3580 = select(_e185, _e3578, (_e3578 < _e185));
let _e3585 = global_3.member[bitcast<u32>(select(0i, _e3580, (_e3580 > 0i)))];
let _e3587 = (_e3193 + _e1965);
let _e3589 = select(_e185, _e3587, (_e3587 < _e185));
let _e3594 = global_3.member[bitcast<u32>(select(0i, _e3589, (_e3589 > 0i)))];
let _e3596 = (select(_e1633, _e3585, _e3497) - _e2971);
let _e3598 = (0.5f * (_e3396 + _e3596));
let _e3601 = bitcast<f32>((bitcast<u32>(_e3596) & 2147483647u));
let _e3604 = (2f * select(_e3601, _e3401, (_e3401 < _e3601)));
let _e3607 = bitcast<f32>((bitcast<u32>(_e3598) & 2147483647u));
let _e3609 = select(_e3604, _e3607, (_e3607 < _e3604));
let _e3617 = select(1e-20f, _e2971, (_e2971 > 1e-20f));
let _e3618 = (select(0f, select(_e3609, -(_e3609), (_e3598 < 0f)), ((_e3396 * _e3596) > 0f)) / _e3617);
let _e3620 = select(-1f, _e3618, (_e3618 > -1f));
let _e3623 = (select(_e1633, _e3594, _e3538) - _e2971);
let _e3625 = (0.5f * (_e2999 + _e3623));
let _e3628 = bitcast<f32>((bitcast<u32>(_e3623) & 2147483647u));
let _e3631 = (2f * select(_e3628, _e3004, (_e3004 < _e3628)));
let _e3634 = bitcast<f32>((bitcast<u32>(_e3625) & 2147483647u));
let _e3636 = select(_e3631, _e3634, (_e3634 < _e3631));
let _e3643 = (select(0f, select(_e3636, -(_e3636), (_e3625 < 0f)), ((_e2999 * _e3623) > 0f)) / _e3617);
let _e3645 = select(-1f, _e3643, (_e3643 > -1f));
let _e3654 = ((_e3530 * _e3571) + (((select(1f, _e3620, (_e3620 < 1f)) * (_e3530 * select(_e3532, -(_e3532), (_e3510 < _e3507)))) * _e3571) + ((select(1f, _e3645, (_e3645 < 1f)) * _e3530) * (_e3571 * select(_e3573, -(_e3573), (_e3551 < _e3548))))));
let _e3656 = select(0f, _e3654, (_e3654 > 0f));
let _e3657 = (_e2517 + _e1965);
let _e3659 = select(_e185, _e3657, (_e3657 < _e185));
let _e3664 = global_3.member[bitcast<u32>(select(0i, _e3659, (_e3659 > 0i)))];
let _e3665 = select(_e1633, _e3664, _e2914);
if _e117 {
phi_11352_ = _e3665;
phi_11353_ = _e3665;
} else {
let _e3667 = ((_e1640 + _e2517) + _e1965);
let _e3669 = select(_e185, _e3667, (_e3667 < _e185));
let _e3674 = global_3.member[bitcast<u32>(select(0i, _e3669, (_e3669 > 0i)))];
let _e3677 = select(_e185, _e3307, (_e3307 < _e185));
let _e3682 = global_3.member[bitcast<u32>(select(0i, _e3677, (_e3677 > 0i)))];
phi_11352_ = select(_e1633, _e3682, _e2914);
phi_11353_ = select(_e1633, _e3674, _e2914);
}
let _e3685 = phi_11352_;
let _e3687 = phi_11353_;
phi_11364_ = type_29(vec3<f32>((((((((((0f + (_e1933 * _e1924)) + (_e2175 * _e2166)) + (_e2418 * _e2409)) + (_e2652 * _e2643)) + (_e2841 * _e2832)) + (_e3041 * _e3032)) + (_e3276 * _e3267)) + (_e3465 * _e3456)) + (_e3665 * _e3656)), (((((((((0f + (_e1955 * _e1924)) + (_e2197 * _e2166)) + (_e2440 * _e2409)) + (_e2674 * _e2643)) + (_e2863 * _e2832)) + (_e3063 * _e3032)) + (_e3298 * _e3267)) + (_e3487 * _e3456)) + (_e3687 * _e3656)), (((((((((0f + (_e1953 * _e1924)) + (_e2195 * _e2166)) + (_e2438 * _e2409)) + (_e2672 * _e2643)) + (_e2861 * _e2832)) + (_e3061 * _e3032)) + (_e3296 * _e3267)) + (_e3485 * _e3456)) + (_e3685 * _e3656))), _e1312, _e1314, _e1316, (((((((((0f + (_e1817 * _e1924)) + (_e1835 * _e2166)) + (_e2083 * _e2409)) + (_e1855 * _e2643)) + (_e2101 * _e2832)) + (_e2344 * _e3032)) + (_e2578 * _e3267)) + (_e2771 * _e3456)) + (_e2971 * _e3656)));
}
let _e3699 = phi_11364_;
global_2.member[_e71] = _e3699.member.x;
global_2.member[(_e69 + _e71)] = _e3699.member.y;
global_2.member[((2u * _e69) + _e71)] = _e3699.member.z;
global_2.member[((3u * _e69) + _e71)] = _e3699.member_1.x;
global_2.member[((4u * _e69) + _e71)] = _e3699.member_1.y;
global_2.member[((5u * _e69) + _e71)] = _e3699.member_1.z;
global_2.member[((6u * _e69) + _e71)] = _e3699.member_2;
global_2.member[((7u * _e69) + _e71)] = _e3699.member_3;
global_2.member[((8u * _e69) + _e71)] = _e3699.member_4;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
