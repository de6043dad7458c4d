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
struct type_29 {
member: vec2<f32>,
member_1: vec3<f32>,
member_2: bool,
}
struct type_32 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(1)
var<storage> global_1: type_16;
@group(0) @binding(0)
var<storage> global_2: type_27;
@group(0) @binding(2)
var<storage, read_write> global_3: type_32;
fn function_() {
var local: i32;
var local_1: i32;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var local_6: i32;
var local_7: i32;
var phi_434_: type_7;
var phi_444_: type_7;
var phi_716_: f32;
var phi_804_: f32;
var phi_1182_: f32;
var phi_1270_: f32;
var phi_1648_: f32;
var phi_1736_: f32;
var phi_2115_: f32;
var phi_2203_: f32;
var phi_3400_: type_29;
var phi_3404_: type_29;
var phi_3409_: type_29;
var phi_3413_: type_29;
var phi_3417_: type_29;
var phi_3422_: type_29;
var phi_3427_: type_29;
var phi_3431_: type_29;
var phi_3436_: type_29;
var phi_3440_: type_29;
var phi_3444_: type_29;
var phi_3449_: type_29;
var phi_3454_: type_29;
var phi_3458_: type_29;
var phi_3487_: f32;
var phi_3700_: i32;
var phi_3735_: i32;
var phi_3826_: vec2<f32>;
var phi_4495_: i32;
var phi_4527_: i32;
var phi_4608_: u32;
var phi_4666_: u32;
var phi_4724_: u32;
var phi_4528_: i32;
var phi_4496_: i32;
var phi_3955_: i32;
var phi_4112_: i32;
var phi_4144_: i32;
var phi_4225_: u32;
var phi_4283_: u32;
var phi_4341_: u32;
var phi_4145_: i32;
var phi_4113_: i32;
var phi_3956_: i32;
var phi_3736_: i32;
var phi_3701_: i32;
var phi_5079_: vec3<f32>;
var phi_5234_: vec3<f32>;
var phi_5389_: vec3<f32>;
var phi_5545_: vec3<f32>;
var phi_5716_: f32;
var phi_5929_: i32;
var phi_5964_: i32;
var phi_6055_: vec2<f32>;
var phi_6724_: i32;
var phi_6756_: i32;
var phi_6837_: u32;
var phi_6895_: u32;
var phi_6953_: u32;
var phi_6757_: i32;
var phi_6725_: i32;
var phi_6184_: i32;
var phi_6341_: i32;
var phi_6373_: i32;
var phi_6454_: u32;
var phi_6512_: u32;
var phi_6570_: u32;
var phi_6374_: i32;
var phi_6342_: i32;
var phi_6185_: i32;
var phi_5965_: i32;
var phi_5930_: i32;
let _e58 = global;
let _e63 = arrayLength((&global_3.member));
let _e66 = global_2.member.member_2;
let _e72 = (_e58.x + _e66.member);
let _e74 = (_e58.y + _e66.member_1);
if (_e72 < _e66.member_2) {
if (_e74 < _e66.member_3) {
let _e79 = global_2.member.member;
let _e85 = global_2.member.member_12.member_4.member;
let _e86 = (_e85 + 1u);
let _e91 = global_2.member.member_12.member_4.member_1;
let _e94 = bitcast<i32>((_e86 * (_e91 + 1u)));
let _e95 = (_e74 * _e86);
let _e97 = bitcast<i32>((_e95 + _e72));
let _e98 = (10i * _e94);
let _e99 = (_e98 + _e97);
let _e101 = (bitcast<i32>(arrayLength((&global_1.member))) - 1i);
let _e103 = select(_e101, _e99, (_e99 < _e101));
let _e109 = global_1.member[bitcast<u32>(select(0i, _e103, (_e103 > 0i)))];
let _e110 = (11i * _e94);
let _e111 = (_e110 + _e97);
let _e113 = select(_e101, _e111, (_e111 < _e101));
let _e119 = global_1.member[bitcast<u32>(select(0i, _e113, (_e113 > 0i)))];
let _e123 = (_e72 + 1u);
let _e125 = bitcast<i32>((_e95 + _e123));
let _e126 = (_e98 + _e125);
let _e128 = select(_e101, _e126, (_e126 < _e101));
let _e134 = global_1.member[bitcast<u32>(select(0i, _e128, (_e128 > 0i)))];
let _e135 = (_e110 + _e125);
let _e137 = select(_e101, _e135, (_e135 < _e101));
let _e143 = global_1.member[bitcast<u32>(select(0i, _e137, (_e137 > 0i)))];
let _e148 = (_e74 + 1u);
let _e149 = (_e148 * _e86);
let _e151 = bitcast<i32>((_e149 + _e72));
let _e152 = (_e98 + _e151);
let _e154 = select(_e101, _e152, (_e152 < _e101));
let _e160 = global_1.member[bitcast<u32>(select(0i, _e154, (_e154 > 0i)))];
let _e161 = (_e110 + _e151);
let _e163 = select(_e101, _e161, (_e161 < _e101));
let _e169 = global_1.member[bitcast<u32>(select(0i, _e163, (_e163 > 0i)))];
let _e175 = bitcast<i32>((_e149 + _e123));
let _e176 = (_e98 + _e175);
let _e178 = select(_e101, _e176, (_e176 < _e101));
let _e184 = global_1.member[bitcast<u32>(select(0i, _e178, (_e178 > 0i)))];
let _e185 = (_e110 + _e175);
let _e187 = select(_e101, _e185, (_e185 < _e101));
let _e193 = global_1.member[bitcast<u32>(select(0i, _e187, (_e187 > 0i)))];
let _e197 = (((((_e109 == 0f) && (_e119 != 1f)) && ((_e134 == 0f) && (_e143 != 1f))) && ((_e160 == 0f) && (_e169 != 1f))) && ((_e184 == 0f) && (_e193 != 1f)));
let _e201 = global_2.member.member_12.member_23;
let _e202 = (_e201 > 0f);
if (!(_e197) || _e202) {
if (_e79.member_2 == 1u) {
let _e215 = global_2.member.member_15.member_1.member;
phi_434_ = _e215;
} else {
let _e210 = global_2.member.member_15.member.member;
phi_434_ = _e210;
}
let _e217 = phi_434_;
let _e221 = global_2.member.member_12.member_21;
if (_e79.member_2 == 2u) {
phi_444_ = type_7(type_5(0f, 0f, -1f), _e221);
} else {
phi_444_ = _e217;
}
let _e225 = phi_444_;
let _e231 = global_2.member.member_12.member_18.member.member;
let _e232 = bitcast<i32>(_e231);
let _e238 = global_2.member.member_12.member_18.member.member_1;
let _e239 = bitcast<i32>(_e238);
local_6 = _e94;
local_7 = _e97;
let _e240 = local_7;
let _e242 = select(_e101, _e240, (_e240 < _e101));
let _e247 = global_1.member[bitcast<u32>(select(0i, _e242, (_e242 > 0i)))];
let _e248 = local_6;
let _e249 = local_7;
let _e250 = (_e248 + _e249);
let _e252 = select(_e101, _e250, (_e250 < _e101));
let _e257 = global_1.member[bitcast<u32>(select(0i, _e252, (_e252 > 0i)))];
let _e258 = local_6;
let _e260 = local_7;
let _e261 = ((2i * _e258) + _e260);
let _e263 = select(_e101, _e261, (_e261 < _e101));
let _e268 = global_1.member[bitcast<u32>(select(0i, _e263, (_e263 > 0i)))];
let _e269 = local_6;
let _e271 = local_7;
let _e272 = ((3i * _e269) + _e271);
let _e274 = select(_e101, _e272, (_e272 < _e101));
let _e279 = global_1.member[bitcast<u32>(select(0i, _e274, (_e274 > 0i)))];
let _e280 = local_6;
let _e282 = local_7;
let _e283 = ((4i * _e280) + _e282);
let _e285 = select(_e101, _e283, (_e283 < _e101));
let _e290 = global_1.member[bitcast<u32>(select(0i, _e285, (_e285 > 0i)))];
let _e291 = local_6;
let _e293 = local_7;
let _e294 = ((5i * _e291) + _e293);
let _e296 = select(_e101, _e294, (_e294 < _e101));
let _e301 = global_1.member[bitcast<u32>(select(0i, _e296, (_e296 > 0i)))];
let _e302 = local_6;
let _e304 = local_7;
let _e305 = ((6i * _e302) + _e304);
let _e307 = select(_e101, _e305, (_e305 < _e101));
let _e312 = global_1.member[bitcast<u32>(select(0i, _e307, (_e307 > 0i)))];
let _e313 = local_6;
let _e315 = local_7;
let _e316 = ((7i * _e313) + _e315);
let _e318 = select(_e101, _e316, (_e316 < _e101));
let _e323 = global_1.member[bitcast<u32>(select(0i, _e318, (_e318 > 0i)))];
let _e324 = local_6;
let _e326 = local_7;
let _e327 = ((8i * _e324) + _e326);
let _e329 = select(_e101, _e327, (_e327 < _e101));
let _e334 = global_1.member[bitcast<u32>(select(0i, _e329, (_e329 > 0i)))];
let _e336 = f32(bitcast<i32>(_e72));
let _e338 = f32(bitcast<i32>(_e74));
let _e342 = global_2.member.member_12.member_3;
let _e343 = (_e342 == 0u);
if _e343 {
phi_716_ = 1f;
} else {
let _e347 = global_2.member.member_12.member_5;
let _e351 = global_2.member.member_12.member_7;
let _e353 = (_e347 + (_e336 * _e351));
let _e357 = global_2.member.member_12.member_6;
let _e359 = (_e357 + (_e338 * _e351));
let _e364 = (((_e353 * _e353) + (_e359 * _e359)) + (1f * 1f));
let _e368 = (1f / sqrt(select(0f, _e364, (_e364 > 0f))));
phi_716_ = ((_e368 * _e368) * _e368);
}
let _e372 = phi_716_;
if _e343 {
phi_804_ = 1f;
} else {
let _e376 = global_2.member.member_12.member_5;
let _e380 = global_2.member.member_12.member_7;
let _e382 = (_e376 + (_e336 * _e380));
let _e386 = global_2.member.member_12.member_6;
let _e388 = (_e386 + (_e338 * _e380));
let _e393 = global_2.member.member_12.member_20.member;
let _e401 = (((_e393.member * _e382) + (_e393.member_1 * _e388)) + (_e393.member_2 * 1f));
let _e405 = (_e382 - (_e393.member * _e401));
let _e406 = (_e388 - (_e393.member_1 * _e401));
let _e407 = (1f - (_e393.member_2 * _e401));
let _e412 = (((_e405 * _e405) + (_e406 * _e406)) + (_e407 * _e407));
let _e423 = global_2.member.member_12.member_20.member_1;
let _e429 = global_2.member.member_12.member_20.member_2;
let _e430 = ((_e423 - (sqrt(select(0f, _e412, (_e412 > 0f))) / select(1e-20f, _e401, (_e401 > 1e-20f)))) * _e429);
let _e432 = select(0f, _e430, (_e430 > 0f));
let _e434 = select(1f, _e432, (_e432 < 1f));
phi_804_ = select(1f, select(0f, ((_e434 * _e434) * (3f - (2f * _e434))), (_e401 > 0f)), (_e429 > 0f));
}
let _e444 = phi_804_;
let _e445 = (_e372 * _e444);
let _e446 = (_e312 * _e445);
let _e447 = (_e323 * _e445);
let _e448 = (_e334 * _e445);
let _e450 = local_6;
let _e452 = local_7;
let _e453 = ((10i * _e450) + _e452);
let _e455 = select(_e101, _e453, (_e453 < _e101));
let _e460 = global_1.member[bitcast<u32>(select(0i, _e455, (_e455 > 0i)))];
let _e461 = local_6;
let _e463 = local_7;
let _e464 = ((11i * _e461) + _e463);
let _e466 = select(_e101, _e464, (_e464 < _e101));
let _e471 = global_1.member[bitcast<u32>(select(0i, _e466, (_e466 > 0i)))];
let _e472 = local_6;
let _e474 = local_7;
let _e475 = ((12i * _e472) + _e474);
let _e477 = select(_e101, _e475, (_e475 < _e101));
let _e482 = global_1.member[bitcast<u32>(select(0i, _e477, (_e477 > 0i)))];
let _e483 = local_6;
let _e485 = local_7;
let _e486 = ((13i * _e483) + _e485);
let _e488 = select(_e101, _e486, (_e486 < _e101));
let _e493 = global_1.member[bitcast<u32>(select(0i, _e488, (_e488 > 0i)))];
local_4 = _e94;
local_5 = _e125;
let _e494 = local_5;
let _e496 = select(_e101, _e494, (_e494 < _e101));
let _e501 = global_1.member[bitcast<u32>(select(0i, _e496, (_e496 > 0i)))];
let _e502 = local_4;
let _e503 = local_5;
let _e504 = (_e502 + _e503);
let _e506 = select(_e101, _e504, (_e504 < _e101));
let _e511 = global_1.member[bitcast<u32>(select(0i, _e506, (_e506 > 0i)))];
let _e512 = local_4;
let _e514 = local_5;
let _e515 = ((2i * _e512) + _e514);
let _e517 = select(_e101, _e515, (_e515 < _e101));
let _e522 = global_1.member[bitcast<u32>(select(0i, _e517, (_e517 > 0i)))];
let _e523 = local_4;
let _e525 = local_5;
let _e526 = ((3i * _e523) + _e525);
let _e528 = select(_e101, _e526, (_e526 < _e101));
let _e533 = global_1.member[bitcast<u32>(select(0i, _e528, (_e528 > 0i)))];
let _e534 = local_4;
let _e536 = local_5;
let _e537 = ((4i * _e534) + _e536);
let _e539 = select(_e101, _e537, (_e537 < _e101));
let _e544 = global_1.member[bitcast<u32>(select(0i, _e539, (_e539 > 0i)))];
let _e545 = local_4;
let _e547 = local_5;
let _e548 = ((5i * _e545) + _e547);
let _e550 = select(_e101, _e548, (_e548 < _e101));
let _e555 = global_1.member[bitcast<u32>(select(0i, _e550, (_e550 > 0i)))];
let _e556 = local_4;
let _e558 = local_5;
let _e559 = ((6i * _e556) + _e558);
let _e561 = select(_e101, _e559, (_e559 < _e101));
let _e566 = global_1.member[bitcast<u32>(select(0i, _e561, (_e561 > 0i)))];
let _e567 = local_4;
let _e569 = local_5;
let _e570 = ((7i * _e567) + _e569);
let _e572 = select(_e101, _e570, (_e570 < _e101));
let _e577 = global_1.member[bitcast<u32>(select(0i, _e572, (_e572 > 0i)))];
let _e578 = local_4;
let _e580 = local_5;
let _e581 = ((8i * _e578) + _e580);
let _e583 = select(_e101, _e581, (_e581 < _e101));
let _e588 = global_1.member[bitcast<u32>(select(0i, _e583, (_e583 > 0i)))];
let _e590 = f32(bitcast<i32>(_e123));
if _e343 {
phi_1182_ = 1f;
} else {
let _e594 = global_2.member.member_12.member_5;
let _e598 = global_2.member.member_12.member_7;
let _e600 = (_e594 + (_e590 * _e598));
let _e604 = global_2.member.member_12.member_6;
let _e606 = (_e604 + (_e338 * _e598));
let _e611 = (((_e600 * _e600) + (_e606 * _e606)) + (1f * 1f));
let _e615 = (1f / sqrt(select(0f, _e611, (_e611 > 0f))));
phi_1182_ = ((_e615 * _e615) * _e615);
}
let _e619 = phi_1182_;
if _e343 {
phi_1270_ = 1f;
} else {
let _e623 = global_2.member.member_12.member_5;
let _e627 = global_2.member.member_12.member_7;
let _e629 = (_e623 + (_e590 * _e627));
let _e633 = global_2.member.member_12.member_6;
let _e635 = (_e633 + (_e338 * _e627));
let _e640 = global_2.member.member_12.member_20.member;
let _e648 = (((_e640.member * _e629) + (_e640.member_1 * _e635)) + (_e640.member_2 * 1f));
let _e652 = (_e629 - (_e640.member * _e648));
let _e653 = (_e635 - (_e640.member_1 * _e648));
let _e654 = (1f - (_e640.member_2 * _e648));
let _e659 = (((_e652 * _e652) + (_e653 * _e653)) + (_e654 * _e654));
let _e670 = global_2.member.member_12.member_20.member_1;
let _e676 = global_2.member.member_12.member_20.member_2;
let _e677 = ((_e670 - (sqrt(select(0f, _e659, (_e659 > 0f))) / select(1e-20f, _e648, (_e648 > 1e-20f)))) * _e676);
let _e679 = select(0f, _e677, (_e677 > 0f));
let _e681 = select(1f, _e679, (_e679 < 1f));
phi_1270_ = select(1f, select(0f, ((_e681 * _e681) * (3f - (2f * _e681))), (_e648 > 0f)), (_e676 > 0f));
}
let _e691 = phi_1270_;
let _e692 = (_e619 * _e691);
let _e693 = (_e566 * _e692);
let _e694 = (_e577 * _e692);
let _e695 = (_e588 * _e692);
let _e697 = local_4;
let _e699 = local_5;
let _e700 = ((10i * _e697) + _e699);
let _e702 = select(_e101, _e700, (_e700 < _e101));
let _e707 = global_1.member[bitcast<u32>(select(0i, _e702, (_e702 > 0i)))];
let _e708 = local_4;
let _e710 = local_5;
let _e711 = ((11i * _e708) + _e710);
let _e713 = select(_e101, _e711, (_e711 < _e101));
let _e718 = global_1.member[bitcast<u32>(select(0i, _e713, (_e713 > 0i)))];
let _e719 = local_4;
let _e721 = local_5;
let _e722 = ((12i * _e719) + _e721);
let _e724 = select(_e101, _e722, (_e722 < _e101));
let _e729 = global_1.member[bitcast<u32>(select(0i, _e724, (_e724 > 0i)))];
let _e730 = local_4;
let _e732 = local_5;
let _e733 = ((13i * _e730) + _e732);
let _e735 = select(_e101, _e733, (_e733 < _e101));
let _e740 = global_1.member[bitcast<u32>(select(0i, _e735, (_e735 > 0i)))];
local_2 = _e94;
local_3 = _e151;
let _e741 = local_3;
let _e743 = select(_e101, _e741, (_e741 < _e101));
let _e748 = global_1.member[bitcast<u32>(select(0i, _e743, (_e743 > 0i)))];
let _e749 = local_2;
let _e750 = local_3;
let _e751 = (_e749 + _e750);
let _e753 = select(_e101, _e751, (_e751 < _e101));
let _e758 = global_1.member[bitcast<u32>(select(0i, _e753, (_e753 > 0i)))];
let _e759 = local_2;
let _e761 = local_3;
let _e762 = ((2i * _e759) + _e761);
let _e764 = select(_e101, _e762, (_e762 < _e101));
let _e769 = global_1.member[bitcast<u32>(select(0i, _e764, (_e764 > 0i)))];
let _e770 = local_2;
let _e772 = local_3;
let _e773 = ((3i * _e770) + _e772);
let _e775 = select(_e101, _e773, (_e773 < _e101));
let _e780 = global_1.member[bitcast<u32>(select(0i, _e775, (_e775 > 0i)))];
let _e781 = local_2;
let _e783 = local_3;
let _e784 = ((4i * _e781) + _e783);
let _e786 = select(_e101, _e784, (_e784 < _e101));
let _e791 = global_1.member[bitcast<u32>(select(0i, _e786, (_e786 > 0i)))];
let _e792 = local_2;
let _e794 = local_3;
let _e795 = ((5i * _e792) + _e794);
let _e797 = select(_e101, _e795, (_e795 < _e101));
let _e802 = global_1.member[bitcast<u32>(select(0i, _e797, (_e797 > 0i)))];
let _e803 = local_2;
let _e805 = local_3;
let _e806 = ((6i * _e803) + _e805);
let _e808 = select(_e101, _e806, (_e806 < _e101));
let _e813 = global_1.member[bitcast<u32>(select(0i, _e808, (_e808 > 0i)))];
let _e814 = local_2;
let _e816 = local_3;
let _e817 = ((7i * _e814) + _e816);
let _e819 = select(_e101, _e817, (_e817 < _e101));
let _e824 = global_1.member[bitcast<u32>(select(0i, _e819, (_e819 > 0i)))];
let _e825 = local_2;
let _e827 = local_3;
let _e828 = ((8i * _e825) + _e827);
let _e830 = select(_e101, _e828, (_e828 < _e101));
let _e835 = global_1.member[bitcast<u32>(select(0i, _e830, (_e830 > 0i)))];
let _e837 = f32(bitcast<i32>(_e148));
if _e343 {
phi_1648_ = 1f;
} else {
let _e841 = global_2.member.member_12.member_5;
let _e845 = global_2.member.member_12.member_7;
let _e847 = (_e841 + (_e336 * _e845));
let _e851 = global_2.member.member_12.member_6;
let _e853 = (_e851 + (_e837 * _e845));
let _e858 = (((_e847 * _e847) + (_e853 * _e853)) + (1f * 1f));
let _e862 = (1f / sqrt(select(0f, _e858, (_e858 > 0f))));
phi_1648_ = ((_e862 * _e862) * _e862);
}
let _e866 = phi_1648_;
if _e343 {
phi_1736_ = 1f;
} else {
let _e870 = global_2.member.member_12.member_5;
let _e874 = global_2.member.member_12.member_7;
let _e876 = (_e870 + (_e336 * _e874));
let _e880 = global_2.member.member_12.member_6;
let _e882 = (_e880 + (_e837 * _e874));
let _e887 = global_2.member.member_12.member_20.member;
let _e895 = (((_e887.member * _e876) + (_e887.member_1 * _e882)) + (_e887.member_2 * 1f));
let _e899 = (_e876 - (_e887.member * _e895));
let _e900 = (_e882 - (_e887.member_1 * _e895));
let _e901 = (1f - (_e887.member_2 * _e895));
let _e906 = (((_e899 * _e899) + (_e900 * _e900)) + (_e901 * _e901));
let _e917 = global_2.member.member_12.member_20.member_1;
let _e923 = global_2.member.member_12.member_20.member_2;
let _e924 = ((_e917 - (sqrt(select(0f, _e906, (_e906 > 0f))) / select(1e-20f, _e895, (_e895 > 1e-20f)))) * _e923);
let _e926 = select(0f, _e924, (_e924 > 0f));
let _e928 = select(1f, _e926, (_e926 < 1f));
phi_1736_ = select(1f, select(0f, ((_e928 * _e928) * (3f - (2f * _e928))), (_e895 > 0f)), (_e923 > 0f));
}
let _e938 = phi_1736_;
let _e939 = (_e866 * _e938);
let _e940 = (_e813 * _e939);
let _e941 = (_e824 * _e939);
let _e942 = (_e835 * _e939);
let _e944 = local_2;
let _e946 = local_3;
let _e947 = ((10i * _e944) + _e946);
let _e949 = select(_e101, _e947, (_e947 < _e101));
let _e954 = global_1.member[bitcast<u32>(select(0i, _e949, (_e949 > 0i)))];
let _e955 = local_2;
let _e957 = local_3;
let _e958 = ((11i * _e955) + _e957);
let _e960 = select(_e101, _e958, (_e958 < _e101));
let _e965 = global_1.member[bitcast<u32>(select(0i, _e960, (_e960 > 0i)))];
let _e966 = local_2;
let _e968 = local_3;
let _e969 = ((12i * _e966) + _e968);
let _e971 = select(_e101, _e969, (_e969 < _e101));
let _e976 = global_1.member[bitcast<u32>(select(0i, _e971, (_e971 > 0i)))];
let _e977 = local_2;
let _e979 = local_3;
let _e980 = ((13i * _e977) + _e979);
let _e982 = select(_e101, _e980, (_e980 < _e101));
let _e987 = global_1.member[bitcast<u32>(select(0i, _e982, (_e982 > 0i)))];
local = _e94;
local_1 = _e175;
let _e988 = local_1;
let _e990 = select(_e101, _e988, (_e988 < _e101));
let _e995 = global_1.member[bitcast<u32>(select(0i, _e990, (_e990 > 0i)))];
let _e996 = local;
let _e997 = local_1;
let _e998 = (_e996 + _e997);
let _e1000 = select(_e101, _e998, (_e998 < _e101));
let _e1005 = global_1.member[bitcast<u32>(select(0i, _e1000, (_e1000 > 0i)))];
let _e1006 = local;
let _e1008 = local_1;
let _e1009 = ((2i * _e1006) + _e1008);
let _e1011 = select(_e101, _e1009, (_e1009 < _e101));
let _e1016 = global_1.member[bitcast<u32>(select(0i, _e1011, (_e1011 > 0i)))];
let _e1017 = local;
let _e1019 = local_1;
let _e1020 = ((3i * _e1017) + _e1019);
let _e1022 = select(_e101, _e1020, (_e1020 < _e101));
let _e1027 = global_1.member[bitcast<u32>(select(0i, _e1022, (_e1022 > 0i)))];
let _e1028 = local;
let _e1030 = local_1;
let _e1031 = ((4i * _e1028) + _e1030);
let _e1033 = select(_e101, _e1031, (_e1031 < _e101));
let _e1038 = global_1.member[bitcast<u32>(select(0i, _e1033, (_e1033 > 0i)))];
let _e1039 = local;
let _e1041 = local_1;
let _e1042 = ((5i * _e1039) + _e1041);
let _e1044 = select(_e101, _e1042, (_e1042 < _e101));
let _e1049 = global_1.member[bitcast<u32>(select(0i, _e1044, (_e1044 > 0i)))];
let _e1050 = local;
let _e1052 = local_1;
let _e1053 = ((6i * _e1050) + _e1052);
let _e1055 = select(_e101, _e1053, (_e1053 < _e101));
let _e1060 = global_1.member[bitcast<u32>(select(0i, _e1055, (_e1055 > 0i)))];
let _e1061 = local;
let _e1063 = local_1;
let _e1064 = ((7i * _e1061) + _e1063);
let _e1066 = select(_e101, _e1064, (_e1064 < _e101));
let _e1071 = global_1.member[bitcast<u32>(select(0i, _e1066, (_e1066 > 0i)))];
let _e1072 = local;
let _e1074 = local_1;
let _e1075 = ((8i * _e1072) + _e1074);
let _e1077 = select(_e101, _e1075, (_e1075 < _e101));
let _e1082 = global_1.member[bitcast<u32>(select(0i, _e1077, (_e1077 > 0i)))];
if _e343 {
phi_2115_ = 1f;
} else {
let _e1086 = global_2.member.member_12.member_5;
let _e1090 = global_2.member.member_12.member_7;
let _e1092 = (_e1086 + (_e590 * _e1090));
let _e1096 = global_2.member.member_12.member_6;
let _e1098 = (_e1096 + (_e837 * _e1090));
let _e1103 = (((_e1092 * _e1092) + (_e1098 * _e1098)) + (1f * 1f));
let _e1107 = (1f / sqrt(select(0f, _e1103, (_e1103 > 0f))));
phi_2115_ = ((_e1107 * _e1107) * _e1107);
}
let _e1111 = phi_2115_;
if _e343 {
phi_2203_ = 1f;
} else {
let _e1115 = global_2.member.member_12.member_5;
let _e1119 = global_2.member.member_12.member_7;
let _e1121 = (_e1115 + (_e590 * _e1119));
let _e1125 = global_2.member.member_12.member_6;
let _e1127 = (_e1125 + (_e837 * _e1119));
let _e1132 = global_2.member.member_12.member_20.member;
let _e1140 = (((_e1132.member * _e1121) + (_e1132.member_1 * _e1127)) + (_e1132.member_2 * 1f));
let _e1144 = (_e1121 - (_e1132.member * _e1140));
let _e1145 = (_e1127 - (_e1132.member_1 * _e1140));
let _e1146 = (1f - (_e1132.member_2 * _e1140));
let _e1151 = (((_e1144 * _e1144) + (_e1145 * _e1145)) + (_e1146 * _e1146));
let _e1162 = global_2.member.member_12.member_20.member_1;
let _e1168 = global_2.member.member_12.member_20.member_2;
let _e1169 = ((_e1162 - (sqrt(select(0f, _e1151, (_e1151 > 0f))) / select(1e-20f, _e1140, (_e1140 > 1e-20f)))) * _e1168);
let _e1171 = select(0f, _e1169, (_e1169 > 0f));
let _e1173 = select(1f, _e1171, (_e1171 < 1f));
phi_2203_ = select(1f, select(0f, ((_e1173 * _e1173) * (3f - (2f * _e1173))), (_e1140 > 0f)), (_e1168 > 0f));
}
let _e1183 = phi_2203_;
let _e1184 = (_e1111 * _e1183);
let _e1185 = (_e1060 * _e1184);
let _e1186 = (_e1071 * _e1184);
let _e1187 = (_e1082 * _e1184);
let _e1189 = local;
let _e1191 = local_1;
let _e1192 = ((10i * _e1189) + _e1191);
let _e1194 = select(_e101, _e1192, (_e1192 < _e101));
let _e1199 = global_1.member[bitcast<u32>(select(0i, _e1194, (_e1194 > 0i)))];
let _e1200 = local;
let _e1202 = local_1;
let _e1203 = ((11i * _e1200) + _e1202);
let _e1205 = select(_e101, _e1203, (_e1203 < _e101));
let _e1210 = global_1.member[bitcast<u32>(select(0i, _e1205, (_e1205 > 0i)))];
let _e1211 = local;
let _e1213 = local_1;
let _e1214 = ((12i * _e1211) + _e1213);
let _e1216 = select(_e101, _e1214, (_e1214 < _e101));
let _e1221 = global_1.member[bitcast<u32>(select(0i, _e1216, (_e1216 > 0i)))];
let _e1222 = local;
let _e1224 = local_1;
let _e1225 = ((13i * _e1222) + _e1224);
let _e1227 = select(_e101, _e1225, (_e1225 < _e101));
let _e1232 = global_1.member[bitcast<u32>(select(0i, _e1227, (_e1227 > 0i)))];
if _e197 {
} else {
let _e1243 = ((((_e225.member.member * _e247) + (_e225.member.member_1 * _e257)) + (_e225.member.member_2 * _e268)) + _e225.member_1);
let _e1249 = -((((_e225.member.member * _e279) + (_e225.member.member_1 * _e290)) + (_e225.member.member_2 * _e301)));
let _e1251 = (_e1249 > 1e-6f);
let _e1255 = select(-1f, (_e1243 / select(1e-6f, _e1249, _e1251)), ((_e1243 >= 0f) && _e1251));
let _e1257 = select(0f, _e1255, (_e1255 > 0f));
let _e1263 = (_e268 + (_e301 * _e1257));
let _e1268 = global_2.member.member_12.member_19.member_2;
let _e1271 = (_e342 != 0u);
let _e1273 = select(1f, (_e1263 - _e1268), _e1271);
let _e1276 = (1f / select(1e-12f, _e1273, (_e1273 > 1e-12f)));
let _e1281 = global_2.member.member_12.member_5;
let _e1286 = global_2.member.member_12.member_8;
let _e1287 = ((((_e247 + (_e279 * _e1257)) * _e1276) - _e1281) * _e1286);
let _e1292 = global_2.member.member_12.member_6;
let _e1294 = ((((_e257 + (_e290 * _e1257)) * _e1276) - _e1292) * _e1286);
let _e1296 = f32(bitcast<i32>(_e85));
let _e1298 = select(0f, _e1287, (_e1287 > 0f));
let _e1305 = global_2.member.member_12.member_18.member_1;
let _e1308 = ((_e1287 - _e1296) * _e1305);
let _e1313 = global_2.member.member_12.member_18.member_2;
let _e1315 = select(0f, _e1308, (_e1308 > 0f));
let _e1317 = (_e1313 + _e1315);
let _e1322 = (-(_e1287) * _e1305);
let _e1324 = select(0f, _e1322, (_e1322 > 0f));
let _e1326 = (_e1313 + _e1324);
let _e1335 = f32(bitcast<i32>(_e91));
let _e1337 = select(0f, _e1294, (_e1294 > 0f));
let _e1342 = ((_e1294 - _e1335) * _e1305);
let _e1344 = select(0f, _e1342, (_e1342 > 0f));
let _e1346 = (_e1313 + _e1344);
let _e1351 = (-(_e1294) * _e1305);
let _e1353 = select(0f, _e1351, (_e1351 > 0f));
let _e1355 = (_e1313 + _e1353);
let _e1367 = (((_e471 == 1f) || (_e1255 < 0f)) || !((_e343 || (_e1263 > _e1268))));
let _e1369 = type_29(vec2<f32>((((_e1313 + (select(_e1296, _e1298, (_e1298 < _e1296)) * _e1305)) + (((_e1315 * _e1313) / select(1e-12f, _e1317, (_e1317 > 1e-12f))) - ((_e1324 * _e1313) / select(1e-12f, _e1326, (_e1326 > 1e-12f))))) - 0.5f), (((_e1313 + (select(_e1335, _e1337, (_e1337 < _e1335)) * _e1305)) + (((_e1344 * _e1313) / select(1e-12f, _e1346, (_e1346 > 1e-12f))) - ((_e1353 * _e1313) / select(1e-12f, _e1355, (_e1355 > 1e-12f))))) - 0.5f)), vec3<f32>(_e446, _e447, _e448), _e1367);
let _e1374 = (((_e279 * _e279) + (_e290 * _e290)) + (_e301 * _e301));
let _e1381 = ((_e1257 * sqrt(select(0f, _e1374, (_e1374 > 0f)))) * select(0f, 1f, (_e460 != 0f)));
let _e1387 = ((((_e225.member.member * _e501) + (_e225.member.member_1 * _e511)) + (_e225.member.member_2 * _e522)) + _e225.member_1);
let _e1393 = -((((_e225.member.member * _e533) + (_e225.member.member_1 * _e544)) + (_e225.member.member_2 * _e555)));
let _e1395 = (_e1393 > 1e-6f);
let _e1399 = select(-1f, (_e1387 / select(1e-6f, _e1393, _e1395)), ((_e1387 >= 0f) && _e1395));
let _e1401 = select(0f, _e1399, (_e1399 > 0f));
let _e1407 = (_e522 + (_e555 * _e1401));
let _e1411 = select(1f, (_e1407 - _e1268), _e1271);
let _e1414 = (1f / select(1e-12f, _e1411, (_e1411 > 1e-12f)));
let _e1417 = ((((_e501 + (_e533 * _e1401)) * _e1414) - _e1281) * _e1286);
let _e1420 = ((((_e511 + (_e544 * _e1401)) * _e1414) - _e1292) * _e1286);
let _e1422 = select(0f, _e1417, (_e1417 > 0f));
let _e1427 = ((_e1417 - _e1296) * _e1305);
let _e1429 = select(0f, _e1427, (_e1427 > 0f));
let _e1431 = (_e1313 + _e1429);
let _e1436 = (-(_e1417) * _e1305);
let _e1438 = select(0f, _e1436, (_e1436 > 0f));
let _e1440 = (_e1313 + _e1438);
let _e1449 = select(0f, _e1420, (_e1420 > 0f));
let _e1454 = ((_e1420 - _e1335) * _e1305);
let _e1456 = select(0f, _e1454, (_e1454 > 0f));
let _e1458 = (_e1313 + _e1456);
let _e1463 = (-(_e1420) * _e1305);
let _e1465 = select(0f, _e1463, (_e1463 > 0f));
let _e1467 = (_e1313 + _e1465);
let _e1479 = (((_e718 == 1f) || (_e1399 < 0f)) || !((_e343 || (_e1407 > _e1268))));
let _e1481 = type_29(vec2<f32>((((_e1313 + (select(_e1296, _e1422, (_e1422 < _e1296)) * _e1305)) + (((_e1429 * _e1313) / select(1e-12f, _e1431, (_e1431 > 1e-12f))) - ((_e1438 * _e1313) / select(1e-12f, _e1440, (_e1440 > 1e-12f))))) - 0.5f), (((_e1313 + (select(_e1335, _e1449, (_e1449 < _e1335)) * _e1305)) + (((_e1456 * _e1313) / select(1e-12f, _e1458, (_e1458 > 1e-12f))) - ((_e1465 * _e1313) / select(1e-12f, _e1467, (_e1467 > 1e-12f))))) - 0.5f)), vec3<f32>(_e693, _e694, _e695), _e1479);
let _e1486 = (((_e533 * _e533) + (_e544 * _e544)) + (_e555 * _e555));
let _e1493 = ((_e1401 * sqrt(select(0f, _e1486, (_e1486 > 0f)))) * select(0f, 1f, (_e707 != 0f)));
let _e1499 = ((((_e225.member.member * _e748) + (_e225.member.member_1 * _e758)) + (_e225.member.member_2 * _e769)) + _e225.member_1);
let _e1505 = -((((_e225.member.member * _e780) + (_e225.member.member_1 * _e791)) + (_e225.member.member_2 * _e802)));
let _e1507 = (_e1505 > 1e-6f);
let _e1511 = select(-1f, (_e1499 / select(1e-6f, _e1505, _e1507)), ((_e1499 >= 0f) && _e1507));
let _e1513 = select(0f, _e1511, (_e1511 > 0f));
let _e1519 = (_e769 + (_e802 * _e1513));
let _e1523 = select(1f, (_e1519 - _e1268), _e1271);
let _e1526 = (1f / select(1e-12f, _e1523, (_e1523 > 1e-12f)));
let _e1529 = ((((_e748 + (_e780 * _e1513)) * _e1526) - _e1281) * _e1286);
let _e1532 = ((((_e758 + (_e791 * _e1513)) * _e1526) - _e1292) * _e1286);
let _e1534 = select(0f, _e1529, (_e1529 > 0f));
let _e1539 = ((_e1529 - _e1296) * _e1305);
let _e1541 = select(0f, _e1539, (_e1539 > 0f));
let _e1543 = (_e1313 + _e1541);
let _e1548 = (-(_e1529) * _e1305);
let _e1550 = select(0f, _e1548, (_e1548 > 0f));
let _e1552 = (_e1313 + _e1550);
let _e1561 = select(0f, _e1532, (_e1532 > 0f));
let _e1566 = ((_e1532 - _e1335) * _e1305);
let _e1568 = select(0f, _e1566, (_e1566 > 0f));
let _e1570 = (_e1313 + _e1568);
let _e1575 = (-(_e1532) * _e1305);
let _e1577 = select(0f, _e1575, (_e1575 > 0f));
let _e1579 = (_e1313 + _e1577);
let _e1591 = (((_e965 == 1f) || (_e1511 < 0f)) || !((_e343 || (_e1519 > _e1268))));
let _e1593 = type_29(vec2<f32>((((_e1313 + (select(_e1296, _e1534, (_e1534 < _e1296)) * _e1305)) + (((_e1541 * _e1313) / select(1e-12f, _e1543, (_e1543 > 1e-12f))) - ((_e1550 * _e1313) / select(1e-12f, _e1552, (_e1552 > 1e-12f))))) - 0.5f), (((_e1313 + (select(_e1335, _e1561, (_e1561 < _e1335)) * _e1305)) + (((_e1568 * _e1313) / select(1e-12f, _e1570, (_e1570 > 1e-12f))) - ((_e1577 * _e1313) / select(1e-12f, _e1579, (_e1579 > 1e-12f))))) - 0.5f)), vec3<f32>(_e940, _e941, _e942), _e1591);
let _e1598 = (((_e780 * _e780) + (_e791 * _e791)) + (_e802 * _e802));
let _e1605 = ((_e1513 * sqrt(select(0f, _e1598, (_e1598 > 0f)))) * select(0f, 1f, (_e954 != 0f)));
let _e1611 = ((((_e225.member.member * _e995) + (_e225.member.member_1 * _e1005)) + (_e225.member.member_2 * _e1016)) + _e225.member_1);
let _e1617 = -((((_e225.member.member * _e1027) + (_e225.member.member_1 * _e1038)) + (_e225.member.member_2 * _e1049)));
let _e1619 = (_e1617 > 1e-6f);
let _e1623 = select(-1f, (_e1611 / select(1e-6f, _e1617, _e1619)), ((_e1611 >= 0f) && _e1619));
let _e1625 = select(0f, _e1623, (_e1623 > 0f));
let _e1631 = (_e1016 + (_e1049 * _e1625));
let _e1635 = select(1f, (_e1631 - _e1268), _e1271);
let _e1638 = (1f / select(1e-12f, _e1635, (_e1635 > 1e-12f)));
let _e1641 = ((((_e995 + (_e1027 * _e1625)) * _e1638) - _e1281) * _e1286);
let _e1644 = ((((_e1005 + (_e1038 * _e1625)) * _e1638) - _e1292) * _e1286);
let _e1646 = select(0f, _e1641, (_e1641 > 0f));
let _e1651 = ((_e1641 - _e1296) * _e1305);
let _e1653 = select(0f, _e1651, (_e1651 > 0f));
let _e1655 = (_e1313 + _e1653);
let _e1660 = (-(_e1641) * _e1305);
let _e1662 = select(0f, _e1660, (_e1660 > 0f));
let _e1664 = (_e1313 + _e1662);
let _e1673 = select(0f, _e1644, (_e1644 > 0f));
let _e1678 = ((_e1644 - _e1335) * _e1305);
let _e1680 = select(0f, _e1678, (_e1678 > 0f));
let _e1682 = (_e1313 + _e1680);
let _e1687 = (-(_e1644) * _e1305);
let _e1689 = select(0f, _e1687, (_e1687 > 0f));
let _e1691 = (_e1313 + _e1689);
let _e1703 = (((_e1210 == 1f) || (_e1623 < 0f)) || !((_e343 || (_e1631 > _e1268))));
let _e1705 = type_29(vec2<f32>((((_e1313 + (select(_e1296, _e1646, (_e1646 < _e1296)) * _e1305)) + (((_e1653 * _e1313) / select(1e-12f, _e1655, (_e1655 > 1e-12f))) - ((_e1662 * _e1313) / select(1e-12f, _e1664, (_e1664 > 1e-12f))))) - 0.5f), (((_e1313 + (select(_e1335, _e1673, (_e1673 < _e1335)) * _e1305)) + (((_e1680 * _e1313) / select(1e-12f, _e1682, (_e1682 > 1e-12f))) - ((_e1689 * _e1313) / select(1e-12f, _e1691, (_e1691 > 1e-12f))))) - 0.5f)), vec3<f32>(_e1185, _e1186, _e1187), _e1703);
let _e1710 = (((_e1027 * _e1027) + (_e1038 * _e1038)) + (_e1049 * _e1049));
let _e1717 = ((_e1625 * sqrt(select(0f, _e1710, (_e1710 > 0f)))) * select(0f, 1f, (_e1199 != 0f)));
let _e1719 = select(_e1493, _e1381, (_e1381 > _e1493));
let _e1721 = select(_e1717, _e1605, (_e1605 > _e1717));
let _e1726 = (((_e201 * select(_e1721, _e1719, (_e1719 > _e1721))) * _e1286) * _e1305);
let _e1737 = (((select(0f, 1f, !(_e1367)) + select(0f, 1f, !(_e1479))) + select(0f, 1f, !(_e1591))) + select(0f, 1f, !(_e1703)));
if (_e1737 > 0f) {
if _e1367 {
phi_3400_ = _e1593;
} else {
phi_3400_ = _e1369;
}
let _e1740 = phi_3400_;
if _e1479 {
phi_3404_ = _e1705;
} else {
phi_3404_ = _e1481;
}
let _e1742 = phi_3404_;
if _e1740.member_2 {
phi_3409_ = _e1742;
} else {
phi_3409_ = _e1740;
}
let _e1745 = phi_3409_;
if _e1479 {
phi_3413_ = _e1745;
} else {
phi_3413_ = _e1481;
}
let _e1747 = phi_3413_;
if _e1367 {
phi_3417_ = _e1747;
} else {
phi_3417_ = _e1369;
}
let _e1749 = phi_3417_;
if _e1742.member_2 {
phi_3422_ = _e1740;
} else {
phi_3422_ = _e1742;
}
let _e1752 = phi_3422_;
if _e1749.member_2 {
phi_3427_ = _e1752;
} else {
phi_3427_ = _e1749;
}
let _e1755 = phi_3427_;
if _e1479 {
phi_3431_ = _e1755;
} else {
phi_3431_ = _e1481;
}
let _e1757 = phi_3431_;
if _e1740.member_2 {
phi_3436_ = _e1742;
} else {
phi_3436_ = _e1740;
}
let _e1759 = phi_3436_;
if _e1703 {
phi_3440_ = _e1759;
} else {
phi_3440_ = _e1705;
}
let _e1761 = phi_3440_;
if _e1591 {
phi_3444_ = _e1761;
} else {
phi_3444_ = _e1593;
}
let _e1763 = phi_3444_;
if _e1742.member_2 {
phi_3449_ = _e1740;
} else {
phi_3449_ = _e1742;
}
let _e1765 = phi_3449_;
if _e1763.member_2 {
phi_3454_ = _e1765;
} else {
phi_3454_ = _e1763;
}
let _e1768 = phi_3454_;
if _e1703 {
phi_3458_ = _e1768;
} else {
phi_3458_ = _e1705;
}
let _e1770 = phi_3458_;
let _e1771 = (1.7320508f * _e1726);
if _e202 {
let _e1774 = (0.5f * select(1f, _e1771, (_e1771 > 1f)));
let _e1776 = select(_e1305, _e1774, (_e1774 > _e1305));
phi_3487_ = select(8f, _e1776, (_e1776 < 8f));
} else {
phi_3487_ = 1f;
}
let _e1780 = phi_3487_;
let _e1790 = (_e1757.member.x - _e1749.member.x);
let _e1791 = (_e1757.member.y - _e1749.member.y);
let _e1794 = bitcast<f32>((bitcast<u32>(_e1790) & 2147483647u));
let _e1797 = bitcast<f32>((bitcast<u32>(_e1791) & 2147483647u));
let _e1799 = select(_e1797, _e1794, (_e1794 > _e1797));
let _e1808 = (_e1770.member.x - _e1763.member.x);
let _e1809 = (_e1770.member.y - _e1763.member.y);
let _e1812 = bitcast<f32>((bitcast<u32>(_e1808) & 2147483647u));
let _e1815 = bitcast<f32>((bitcast<u32>(_e1809) & 2147483647u));
let _e1817 = select(_e1815, _e1812, (_e1812 > _e1815));
let _e1821 = ((select(_e1817, _e1799, (_e1799 > _e1817)) / _e1780) - 1e-3f);
let _e1822 = (128f - 1f);
let _e1824 = select(0f, _e1821, (_e1821 > 0f));
let _e1826 = select(_e1822, _e1824, (_e1824 < _e1822));
let _e1833 = select(0i, select(select(i32(_e1826), i32(-2147483648), (_e1826 < -2147483600f)), 2147483647i, (_e1826 > 2147483500f)), (_e1826 == _e1826));
let _e1839 = f32((1i + (_e1833 - select(0i, 1i, (_e1826 < f32(_e1833))))));
let _e1840 = (_e1763.member.x - _e1749.member.x);
let _e1841 = (_e1763.member.y - _e1749.member.y);
let _e1844 = bitcast<f32>((bitcast<u32>(_e1840) & 2147483647u));
let _e1847 = bitcast<f32>((bitcast<u32>(_e1841) & 2147483647u));
let _e1849 = select(_e1847, _e1844, (_e1844 > _e1847));
let _e1850 = (_e1770.member.x - _e1757.member.x);
let _e1851 = (_e1770.member.y - _e1757.member.y);
let _e1854 = bitcast<f32>((bitcast<u32>(_e1850) & 2147483647u));
let _e1857 = bitcast<f32>((bitcast<u32>(_e1851) & 2147483647u));
let _e1859 = select(_e1857, _e1854, (_e1854 > _e1857));
let _e1863 = ((select(_e1859, _e1849, (_e1849 > _e1859)) / _e1780) - 1e-3f);
let _e1865 = select(0f, _e1863, (_e1863 > 0f));
let _e1867 = select(_e1822, _e1865, (_e1865 < _e1822));
let _e1874 = select(0i, select(select(i32(_e1867), i32(-2147483648), (_e1867 < -2147483600f)), 2147483647i, (_e1867 > 2147483500f)), (_e1867 == _e1867));
let _e1880 = f32((1i + (_e1874 - select(0i, 1i, (_e1867 < f32(_e1874))))));
let _e1882 = (select(128f, 24f, _e202) / (_e1839 * _e1880));
let _e1884 = select(_e1882, 1f, (1f < _e1882));
let _e1887 = sqrt(select(0f, _e1884, (_e1884 > 0f)));
let _e1888 = (_e1839 * _e1887);
let _e1890 = select(1f, _e1888, (_e1888 > 1f));
let _e1892 = select(128f, _e1890, (_e1890 < 128f));
let _e1899 = select(0i, select(select(i32(_e1892), i32(-2147483648), (_e1892 < -2147483600f)), 2147483647i, (_e1892 > 2147483500f)), (_e1892 == _e1892));
let _e1903 = (_e1899 - select(0i, 1i, (_e1892 < f32(_e1899))));
let _e1904 = (_e1880 * _e1887);
let _e1906 = select(1f, _e1904, (_e1904 > 1f));
let _e1908 = select(128f, _e1906, (_e1906 < 128f));
let _e1915 = select(0i, select(select(i32(_e1908), i32(-2147483648), (_e1908 < -2147483600f)), 2147483647i, (_e1908 > 2147483500f)), (_e1908 == _e1908));
let _e1919 = (_e1915 - select(0i, 1i, (_e1908 < f32(_e1915))));
let _e1921 = (1f / f32(_e1903));
let _e1923 = (1f / f32(_e1919));
let _e1926 = ((_e1921 * _e1923) * (_e1737 * 0.25f));
phi_3700_ = 0i;
loop {
let _e1928 = phi_3700_;
let _e1929 = (_e1928 < _e1919);
if _e1929 {
let _e1932 = ((f32(_e1928) + 0.5f) * _e1923);
phi_3735_ = 0i;
loop {
let _e1940 = phi_3735_;
let _e1941 = (_e1940 < _e1903);
if _e1941 {
let _e1944 = ((f32(_e1940) + 0.5f) * _e1921);
let _e1951 = ((_e1790 + ((_e1808 - _e1790) * _e1932)) * _e1921);
let _e1952 = ((_e1791 + ((_e1809 - _e1791) * _e1932)) * _e1921);
let _e1953 = ((_e1840 + ((_e1850 - _e1840) * _e1944)) * _e1923);
let _e1954 = ((_e1841 + ((_e1851 - _e1841) * _e1944)) * _e1923);
let _e1960 = bitcast<f32>((bitcast<u32>(((_e1951 * _e1954) - (_e1952 * _e1953))) & 2147483647u));
let _e1963 = bitcast<f32>((bitcast<u32>(_e1951) & 2147483647u));
let _e1966 = bitcast<f32>((bitcast<u32>(_e1954) & 2147483647u));
let _e1969 = bitcast<f32>((bitcast<u32>(_e1953) & 2147483647u));
let _e1970 = (_e1963 + _e1969);
let _e1973 = bitcast<f32>((bitcast<u32>(_e1952) & 2147483647u));
let _e1974 = (_e1966 + _e1973);
let _e1978 = (9.765625e-4f * 9.765625e-4f);
let _e1981 = (_e1960 / select(_e1978, _e1963, (_e1963 > _e1978)));
let _e1986 = (_e1960 / select(_e1978, _e1966, (_e1966 > _e1978)));
if ((_e1969 * _e1966) <= (_e1973 * _e1963)) {
phi_3826_ = vec2<f32>(_e1963, select(_e1974, _e1981, (_e1981 < _e1974)));
} else {
phi_3826_ = vec2<f32>(select(_e1970, _e1986, (_e1986 < _e1970)), _e1966);
}
let _e1992 = phi_3826_;
let _e1996 = (_e1749.member.x + (_e1790 * _e1944));
let _e2001 = (_e1996 + (((_e1763.member.x + (_e1808 * _e1944)) - _e1996) * _e1932));
let _e2003 = (_e1749.member.y + (_e1791 * _e1944));
let _e2008 = (_e2003 + (((_e1763.member.y + (_e1809 * _e1944)) - _e2003) * _e1932));
let _e2019 = (_e1749.member_1.x + ((_e1757.member_1.x - _e1749.member_1.x) * _e1944));
let _e2026 = ((_e2019 + (((_e1763.member_1.x + ((_e1770.member_1.x - _e1763.member_1.x) * _e1944)) - _e2019) * _e1932)) * _e1926);
let _e2037 = (_e1749.member_1.y + ((_e1757.member_1.y - _e1749.member_1.y) * _e1944));
let _e2044 = ((_e2037 + (((_e1763.member_1.y + ((_e1770.member_1.y - _e1763.member_1.y) * _e1944)) - _e2037) * _e1932)) * _e1926);
let _e2055 = (_e1749.member_1.z + ((_e1757.member_1.z - _e1749.member_1.z) * _e1944));
let _e2062 = ((_e2055 + (((_e1763.member_1.z + ((_e1770.member_1.z - _e1763.member_1.z) * _e1944)) - _e2055) * _e1932)) * _e1926);
if _e202 {
let _e2312 = select(1f, _e1992.x, (_e1992.x > 1f));
let _e2314 = select(8f, _e2312, (_e2312 < 8f));
let _e2316 = select(1f, _e1992.y, (_e1992.y > 1f));
let _e2318 = select(8f, _e2316, (_e2316 < 8f));
let _e2320 = (0.5f * (_e2314 + _e2318));
let _e2324 = (((3f * _e1726) * _e1726) - (_e2320 * _e2320));
let _e2325 = (1f * 1f);
let _e2327 = select(_e2325, _e2324, (_e2324 > _e2325));
let _e2330 = sqrt(select(0f, _e2327, (_e2327 > 0f)));
let _e2332 = (1f / (_e2330 * _e2330));
phi_3955_ = 0i;
loop {
let _e2337 = phi_3955_;
let _e2338 = (_e2337 < 4i);
if _e2338 {
let _e2340 = f32((_e2337 & 1i));
let _e2343 = f32((_e2337 >> bitcast<u32>(1i)));
let _e2348 = ((1f - (2f * _e2340)) * (1f - (2f * _e2343)));
let _e2352 = ((_e2001 + ((_e2340 - 0.5f) * _e2330)) + 0.5f);
let _e2356 = ((_e2008 + ((_e2343 - 0.5f) * _e2330)) + 0.5f);
let _e2357 = (0.5f * _e2314);
let _e2358 = (_e2357 - 0.5f);
let _e2361 = (0.5f * _e2318);
let _e2362 = (_e2361 - 0.5f);
let _e2368 = (select(_e2358, _e2352, (_e2352 > _e2358)) - _e2357);
let _e2369 = (select(_e2362, _e2356, (_e2356 > _e2362)) - _e2361);
let _e2370 = (_e2368 + 0.5f);
let _e2372 = select(0f, _e2370, (_e2370 > 0f));
let _e2374 = select(65536f, _e2372, (_e2372 < 65536f));
let _e2381 = select(0i, select(select(i32(_e2374), i32(-2147483648), (_e2374 < -2147483600f)), 2147483647i, (_e2374 > 2147483500f)), (_e2374 == _e2374));
let _e2386 = (_e2368 + _e2314);
let _e2387 = (_e2386 + 0.5f);
let _e2389 = f32((_e232 - 1i));
let _e2391 = select(-1f, _e2387, (_e2387 > -1f));
let _e2393 = select(_e2389, _e2391, (_e2391 < _e2389));
let _e2400 = select(0i, select(select(i32(_e2393), i32(-2147483648), (_e2393 < -2147483600f)), 2147483647i, (_e2393 > 2147483500f)), (_e2393 == _e2393));
let _e2405 = (_e2369 + _e2318);
let _e2406 = (_e2405 + 0.5f);
let _e2408 = f32((_e239 - 1i));
let _e2410 = select(-1f, _e2406, (_e2406 > -1f));
let _e2412 = select(_e2408, _e2410, (_e2410 < _e2408));
let _e2419 = select(0i, select(select(i32(_e2412), i32(-2147483648), (_e2412 < -2147483600f)), 2147483647i, (_e2412 > 2147483500f)), (_e2412 == _e2412));
let _e2424 = (_e2369 + 0.5f);
let _e2426 = select(0f, _e2424, (_e2424 > 0f));
let _e2428 = select(65536f, _e2426, (_e2426 < 65536f));
let _e2435 = select(0i, select(select(i32(_e2428), i32(-2147483648), (_e2428 < -2147483600f)), 2147483647i, (_e2428 > 2147483500f)), (_e2428 == _e2428));
phi_4112_ = (_e2435 - select(0i, 1i, (_e2428 < f32(_e2435))));
loop {
let _e2441 = phi_4112_;
let _e2442 = (_e2441 <= (_e2419 - select(0i, 1i, (_e2412 < f32(_e2419)))));
if _e2442 {
let _e2443 = f32(_e2441);
let _e2444 = (_e2443 - 0.5f);
let _e2447 = (_e2443 + 0.5f);
let _e2450 = (select(_e2447, _e2405, (_e2405 < _e2447)) - select(_e2444, _e2369, (_e2369 > _e2444)));
phi_4144_ = (_e2381 - select(0i, 1i, (_e2374 < f32(_e2381))));
loop {
let _e2455 = phi_4144_;
let _e2456 = (_e2455 <= (_e2400 - select(0i, 1i, (_e2393 < f32(_e2400)))));
if _e2456 {
let _e2457 = f32(_e2455);
let _e2458 = (_e2457 - 0.5f);
let _e2461 = (_e2457 + 0.5f);
let _e2464 = (select(_e2461, _e2386, (_e2386 < _e2461)) - select(_e2458, _e2368, (_e2368 > _e2458)));
let _e2468 = ((select(0f, _e2464, (_e2464 > 0f)) / _e2314) * (select(0f, _e2450, (_e2450 > 0f)) / _e2318));
if (_e2468 > 0f) {
let _e2472 = (((_e2441 * _e232) + _e2455) * 6i);
let _e2475 = (((((_e2026 * _e2332) * _e2348) * _e2468) * 16777216f) + 0.5f);
let _e2477 = select(-1073741800f, _e2475, (_e2475 > -1073741800f));
let _e2479 = select(1073741800f, _e2477, (_e2477 < 1073741800f));
let _e2486 = select(0i, select(select(i32(_e2479), i32(-2147483648), (_e2479 < -2147483600f)), 2147483647i, (_e2479 > 2147483500f)), (_e2479 == _e2479));
let _e2490 = (_e2486 - select(0i, 1i, (_e2479 < f32(_e2486))));
let _e2491 = bitcast<u32>(_e2490);
let _e2494 = bitcast<u32>((_e2490 >> bitcast<u32>(31i)));
if ((_e2491 | _e2494) == 0u) {
} else {
let _e2497 = bitcast<u32>(_e2472);
if (_e2497 < _e63) {
let _e2501 = atomicAdd((&global_3.member[_e2497]), _e2491);
phi_4225_ = _e2501;
} else {
phi_4225_ = 0u;
}
let _e2503 = phi_4225_;
let _e2507 = (_e2494 + select(0u, 1u, ((_e2503 + _e2491) < _e2491)));
if (_e2507 == 0u) {
} else {
let _e2509 = (_e2497 + 1u);
if (_e2509 < _e63) {
let _e2513 = atomicAdd((&global_3.member[_e2509]), _e2507);
}
}
}
let _e2517 = (((((_e2044 * _e2332) * _e2348) * _e2468) * 16777216f) + 0.5f);
let _e2519 = select(-1073741800f, _e2517, (_e2517 > -1073741800f));
let _e2521 = select(1073741800f, _e2519, (_e2519 < 1073741800f));
let _e2528 = select(0i, select(select(i32(_e2521), i32(-2147483648), (_e2521 < -2147483600f)), 2147483647i, (_e2521 > 2147483500f)), (_e2521 == _e2521));
let _e2532 = (_e2528 - select(0i, 1i, (_e2521 < f32(_e2528))));
let _e2533 = bitcast<u32>(_e2532);
let _e2536 = bitcast<u32>((_e2532 >> bitcast<u32>(31i)));
if ((_e2533 | _e2536) == 0u) {
} else {
let _e2539 = bitcast<u32>((_e2472 + 2i));
if (_e2539 < _e63) {
let _e2543 = atomicAdd((&global_3.member[_e2539]), _e2533);
phi_4283_ = _e2543;
} else {
phi_4283_ = 0u;
}
let _e2545 = phi_4283_;
let _e2549 = (_e2536 + select(0u, 1u, ((_e2545 + _e2533) < _e2533)));
if (_e2549 == 0u) {
} else {
let _e2551 = (_e2539 + 1u);
if (_e2551 < _e63) {
let _e2555 = atomicAdd((&global_3.member[_e2551]), _e2549);
}
}
}
let _e2559 = (((((_e2062 * _e2332) * _e2348) * _e2468) * 16777216f) + 0.5f);
let _e2561 = select(-1073741800f, _e2559, (_e2559 > -1073741800f));
let _e2563 = select(1073741800f, _e2561, (_e2561 < 1073741800f));
let _e2570 = select(0i, select(select(i32(_e2563), i32(-2147483648), (_e2563 < -2147483600f)), 2147483647i, (_e2563 > 2147483500f)), (_e2563 == _e2563));
let _e2574 = (_e2570 - select(0i, 1i, (_e2563 < f32(_e2570))));
let _e2575 = bitcast<u32>(_e2574);
let _e2578 = bitcast<u32>((_e2574 >> bitcast<u32>(31i)));
if ((_e2575 | _e2578) == 0u) {
} else {
let _e2581 = bitcast<u32>((_e2472 + 4i));
if (_e2581 < _e63) {
let _e2585 = atomicAdd((&global_3.member[_e2581]), _e2575);
phi_4341_ = _e2585;
} else {
phi_4341_ = 0u;
}
let _e2587 = phi_4341_;
let _e2591 = (_e2578 + select(0u, 1u, ((_e2587 + _e2575) < _e2575)));
if (_e2591 == 0u) {
} else {
let _e2593 = (_e2581 + 1u);
if (_e2593 < _e63) {
let _e2597 = atomicAdd((&global_3.member[_e2593]), _e2591);
}
}
}
}
phi_4145_ = (_e2455 + 1i);
} else {
phi_4145_ = i32();
}
let _e2600 = phi_4145_;
continue;
continuing {
phi_4144_ = _e2600;
break if !(_e2456);
}
}
phi_4113_ = (_e2441 + 1i);
} else {
phi_4113_ = i32();
}
let _e2604 = phi_4113_;
continue;
continuing {
phi_4112_ = _e2604;
break if !(_e2442);
}
}
phi_3956_ = (_e2337 + 1i);
} else {
phi_3956_ = i32();
}
let _e2608 = phi_3956_;
continue;
continuing {
phi_3955_ = _e2608;
break if !(_e2338);
}
}
} else {
let _e2064 = select(9.765625e-4f, _e1992.x, (_e1992.x > 9.765625e-4f));
let _e2066 = select(5f, _e2064, (_e2064 < 5f));
let _e2068 = select(9.765625e-4f, _e1992.y, (_e1992.y > 9.765625e-4f));
let _e2070 = select(5f, _e2068, (_e2068 < 5f));
let _e2072 = (_e2001 - (0.5f * _e2066));
let _e2074 = (_e2008 - (0.5f * _e2070));
let _e2075 = (_e2072 + 0.5f);
let _e2077 = select(0f, _e2075, (_e2075 > 0f));
let _e2079 = select(65536f, _e2077, (_e2077 < 65536f));
let _e2086 = select(0i, select(select(i32(_e2079), i32(-2147483648), (_e2079 < -2147483600f)), 2147483647i, (_e2079 > 2147483500f)), (_e2079 == _e2079));
let _e2091 = (_e2072 + _e2066);
let _e2092 = (_e2091 + 0.5f);
let _e2094 = f32((_e232 - 1i));
let _e2096 = select(-1f, _e2092, (_e2092 > -1f));
let _e2098 = select(_e2094, _e2096, (_e2096 < _e2094));
let _e2105 = select(0i, select(select(i32(_e2098), i32(-2147483648), (_e2098 < -2147483600f)), 2147483647i, (_e2098 > 2147483500f)), (_e2098 == _e2098));
let _e2110 = (_e2074 + _e2070);
let _e2111 = (_e2110 + 0.5f);
let _e2113 = f32((_e239 - 1i));
let _e2115 = select(-1f, _e2111, (_e2111 > -1f));
let _e2117 = select(_e2113, _e2115, (_e2115 < _e2113));
let _e2124 = select(0i, select(select(i32(_e2117), i32(-2147483648), (_e2117 < -2147483600f)), 2147483647i, (_e2117 > 2147483500f)), (_e2117 == _e2117));
let _e2129 = (_e2074 + 0.5f);
let _e2131 = select(0f, _e2129, (_e2129 > 0f));
let _e2133 = select(65536f, _e2131, (_e2131 < 65536f));
let _e2140 = select(0i, select(select(i32(_e2133), i32(-2147483648), (_e2133 < -2147483600f)), 2147483647i, (_e2133 > 2147483500f)), (_e2133 == _e2133));
phi_4495_ = (_e2140 - select(0i, 1i, (_e2133 < f32(_e2140))));
loop {
let _e2146 = phi_4495_;
let _e2147 = (_e2146 <= (_e2124 - select(0i, 1i, (_e2117 < f32(_e2124)))));
if _e2147 {
let _e2148 = f32(_e2146);
let _e2149 = (_e2148 - 0.5f);
let _e2152 = (_e2148 + 0.5f);
let _e2155 = (select(_e2152, _e2110, (_e2110 < _e2152)) - select(_e2149, _e2074, (_e2074 > _e2149)));
phi_4527_ = (_e2086 - select(0i, 1i, (_e2079 < f32(_e2086))));
loop {
let _e2160 = phi_4527_;
let _e2161 = (_e2160 <= (_e2105 - select(0i, 1i, (_e2098 < f32(_e2105)))));
if _e2161 {
let _e2162 = f32(_e2160);
let _e2163 = (_e2162 - 0.5f);
let _e2166 = (_e2162 + 0.5f);
let _e2169 = (select(_e2166, _e2091, (_e2091 < _e2166)) - select(_e2163, _e2072, (_e2072 > _e2163)));
let _e2173 = ((select(0f, _e2169, (_e2169 > 0f)) / _e2066) * (select(0f, _e2155, (_e2155 > 0f)) / _e2070));
if (_e2173 > 0f) {
let _e2177 = (((_e2146 * _e232) + _e2160) * 6i);
let _e2180 = (((_e2026 * _e2173) * 16777216f) + 0.5f);
let _e2182 = select(-1073741800f, _e2180, (_e2180 > -1073741800f));
let _e2184 = select(1073741800f, _e2182, (_e2182 < 1073741800f));
let _e2191 = select(0i, select(select(i32(_e2184), i32(-2147483648), (_e2184 < -2147483600f)), 2147483647i, (_e2184 > 2147483500f)), (_e2184 == _e2184));
let _e2195 = (_e2191 - select(0i, 1i, (_e2184 < f32(_e2191))));
let _e2196 = bitcast<u32>(_e2195);
let _e2199 = bitcast<u32>((_e2195 >> bitcast<u32>(31i)));
if ((_e2196 | _e2199) == 0u) {
} else {
let _e2202 = bitcast<u32>(_e2177);
if (_e2202 < _e63) {
let _e2206 = atomicAdd((&global_3.member[_e2202]), _e2196);
phi_4608_ = _e2206;
} else {
phi_4608_ = 0u;
}
let _e2208 = phi_4608_;
let _e2212 = (_e2199 + select(0u, 1u, ((_e2208 + _e2196) < _e2196)));
if (_e2212 == 0u) {
} else {
let _e2214 = (_e2202 + 1u);
if (_e2214 < _e63) {
let _e2218 = atomicAdd((&global_3.member[_e2214]), _e2212);
}
}
}
let _e2222 = (((_e2044 * _e2173) * 16777216f) + 0.5f);
let _e2224 = select(-1073741800f, _e2222, (_e2222 > -1073741800f));
let _e2226 = select(1073741800f, _e2224, (_e2224 < 1073741800f));
let _e2233 = select(0i, select(select(i32(_e2226), i32(-2147483648), (_e2226 < -2147483600f)), 2147483647i, (_e2226 > 2147483500f)), (_e2226 == _e2226));
let _e2237 = (_e2233 - select(0i, 1i, (_e2226 < f32(_e2233))));
let _e2238 = bitcast<u32>(_e2237);
let _e2241 = bitcast<u32>((_e2237 >> bitcast<u32>(31i)));
if ((_e2238 | _e2241) == 0u) {
} else {
let _e2244 = bitcast<u32>((_e2177 + 2i));
if (_e2244 < _e63) {
let _e2248 = atomicAdd((&global_3.member[_e2244]), _e2238);
phi_4666_ = _e2248;
} else {
phi_4666_ = 0u;
}
let _e2250 = phi_4666_;
let _e2254 = (_e2241 + select(0u, 1u, ((_e2250 + _e2238) < _e2238)));
if (_e2254 == 0u) {
} else {
let _e2256 = (_e2244 + 1u);
if (_e2256 < _e63) {
let _e2260 = atomicAdd((&global_3.member[_e2256]), _e2254);
}
}
}
let _e2264 = (((_e2062 * _e2173) * 16777216f) + 0.5f);
let _e2266 = select(-1073741800f, _e2264, (_e2264 > -1073741800f));
let _e2268 = select(1073741800f, _e2266, (_e2266 < 1073741800f));
let _e2275 = select(0i, select(select(i32(_e2268), i32(-2147483648), (_e2268 < -2147483600f)), 2147483647i, (_e2268 > 2147483500f)), (_e2268 == _e2268));
let _e2279 = (_e2275 - select(0i, 1i, (_e2268 < f32(_e2275))));
let _e2280 = bitcast<u32>(_e2279);
let _e2283 = bitcast<u32>((_e2279 >> bitcast<u32>(31i)));
if ((_e2280 | _e2283) == 0u) {
} else {
let _e2286 = bitcast<u32>((_e2177 + 4i));
if (_e2286 < _e63) {
let _e2290 = atomicAdd((&global_3.member[_e2286]), _e2280);
phi_4724_ = _e2290;
} else {
phi_4724_ = 0u;
}
let _e2292 = phi_4724_;
let _e2296 = (_e2283 + select(0u, 1u, ((_e2292 + _e2280) < _e2280)));
if (_e2296 == 0u) {
} else {
let _e2298 = (_e2286 + 1u);
if (_e2298 < _e63) {
let _e2302 = atomicAdd((&global_3.member[_e2298]), _e2296);
}
}
}
}
phi_4528_ = (_e2160 + 1i);
} else {
phi_4528_ = i32();
}
let _e2305 = phi_4528_;
continue;
continuing {
phi_4527_ = _e2305;
break if !(_e2161);
}
}
phi_4496_ = (_e2146 + 1i);
} else {
phi_4496_ = i32();
}
let _e2309 = phi_4496_;
continue;
continuing {
phi_4495_ = _e2309;
break if !(_e2147);
}
}
}
phi_3736_ = (_e1940 + 1i);
} else {
phi_3736_ = i32();
}
let _e2612 = phi_3736_;
continue;
continuing {
phi_3735_ = _e2612;
break if !(_e1941);
}
}
phi_3701_ = (_e1928 + 1i);
} else {
phi_3701_ = i32();
}
let _e2616 = phi_3701_;
continue;
continuing {
phi_3700_ = _e2616;
break if !(_e1929);
}
}
}
}
let _e2620 = (1f / 3f);
let _e2622 = (_e460 != 0f);
let _e2628 = (_e707 != 0f);
let _e2635 = (_e954 != 0f);
let _e2641 = (_e1199 != 0f);
let _e2645 = (((1f - select((((_e446 + _e447) + _e448) * _e2620), 0f, _e2622)) + (1f - select((((_e693 + _e694) + _e695) * _e2620), 0f, _e2628))) + ((1f - select((((_e940 + _e941) + _e942) * _e2620), 0f, _e2635)) + (1f - select((((_e1185 + _e1186) + _e1187) * _e2620), 0f, _e2641))));
if (_e202 && (_e2645 > 0f)) {
let _e2655 = (((select(_e482, _e493, _e2622) + select(_e729, _e740, _e2628)) + (select(_e976, _e987, _e2635) + select(_e1221, _e1232, _e2641))) / _e2645);
let _e2658 = (_e342 != 0u);
let _e2666 = global_2.member.member_12.member_19.member_2;
let _e2668 = select(1f, (_e2655 - _e2666), _e2658);
let _e2672 = global_2.member.member_12.member_5;
let _e2676 = global_2.member.member_12.member_7;
let _e2679 = ((_e2672 + ((_e336 + 0.5f) * _e2676)) * _e2668);
let _e2683 = global_2.member.member_12.member_6;
let _e2686 = ((_e2683 + ((_e338 + 0.5f) * _e2676)) * _e2668);
let _e2687 = global_2.member.member_12.member_19;
let _e2691 = (_e2679 - _e2687.member);
let _e2692 = (_e2686 - _e2687.member_1);
let _e2693 = (_e2655 - _e2687.member_2);
let _e2698 = (((_e2691 * _e2691) + (_e2692 * _e2692)) + (_e2693 * _e2693));
let _e2701 = sqrt(select(0f, _e2698, (_e2698 > 0f)));
let _e2704 = (1f / select(1e-20f, _e2701, (_e2701 > 1e-20f)));
let _e2721 = ((((_e225.member.member * _e2679) + (_e225.member.member_1 * _e2686)) + (_e225.member.member_2 * _e2655)) + _e225.member_1);
let _e2727 = -((((_e225.member.member * select(0f, (_e2691 * _e2704), _e2658)) + (_e225.member.member_1 * select(0f, (_e2692 * _e2704), _e2658))) + (_e225.member.member_2 * select(1f, (_e2693 * _e2704), _e2658))));
let _e2729 = (_e2727 > 1e-6f);
let _e2733 = select(-1f, (_e2721 / select(1e-6f, _e2727, _e2729)), ((_e2721 >= 0f) && _e2729));
if (_e2733 >= 0f) {
let _e2736 = f32(bitcast<i32>(_e85));
let _e2738 = select(0f, _e336, (_e336 > 0f));
let _e2745 = global_2.member.member_12.member_18.member_1;
let _e2748 = ((_e336 - _e2736) * _e2745);
let _e2753 = global_2.member.member_12.member_18.member_2;
let _e2755 = select(0f, _e2748, (_e2748 > 0f));
let _e2757 = (_e2753 + _e2755);
let _e2762 = (-(_e336) * _e2745);
let _e2764 = select(0f, _e2762, (_e2762 > 0f));
let _e2766 = (_e2753 + _e2764);
let _e2773 = (((_e2753 + (select(_e2736, _e2738, (_e2738 < _e2736)) * _e2745)) + (((_e2755 * _e2753) / select(1e-12f, _e2757, (_e2757 > 1e-12f))) - ((_e2764 * _e2753) / select(1e-12f, _e2766, (_e2766 > 1e-12f))))) - 0.5f);
let _e2775 = f32(bitcast<i32>(_e91));
let _e2777 = select(0f, _e338, (_e338 > 0f));
let _e2782 = ((_e338 - _e2775) * _e2745);
let _e2784 = select(0f, _e2782, (_e2782 > 0f));
let _e2786 = (_e2753 + _e2784);
let _e2791 = (-(_e338) * _e2745);
let _e2793 = select(0f, _e2791, (_e2791 > 0f));
let _e2795 = (_e2753 + _e2793);
let _e2802 = (((_e2753 + (select(_e2775, _e2777, (_e2777 < _e2775)) * _e2745)) + (((_e2784 * _e2753) / select(1e-12f, _e2786, (_e2786 > 1e-12f))) - ((_e2793 * _e2753) / select(1e-12f, _e2795, (_e2795 > 1e-12f))))) - 0.5f);
if _e197 {
phi_5079_ = vec3<f32>((_e446 + -1f), (_e447 + -1f), (_e448 + -1f));
} else {
phi_5079_ = vec3<f32>(-1f, -1f, -1f);
}
let _e2808 = phi_5079_;
let _e2810 = select(0f, _e590, (_e590 > 0f));
let _e2815 = ((_e590 - _e2736) * _e2745);
let _e2817 = select(0f, _e2815, (_e2815 > 0f));
let _e2819 = (_e2753 + _e2817);
let _e2824 = (-(_e590) * _e2745);
let _e2826 = select(0f, _e2824, (_e2824 > 0f));
let _e2828 = (_e2753 + _e2826);
let _e2835 = (((_e2753 + (select(_e2736, _e2810, (_e2810 < _e2736)) * _e2745)) + (((_e2817 * _e2753) / select(1e-12f, _e2819, (_e2819 > 1e-12f))) - ((_e2826 * _e2753) / select(1e-12f, _e2828, (_e2828 > 1e-12f))))) - 0.5f);
if _e197 {
phi_5234_ = vec3<f32>((_e693 + -1f), (_e694 + -1f), (_e695 + -1f));
} else {
phi_5234_ = vec3<f32>(-1f, -1f, -1f);
}
let _e2841 = phi_5234_;
let _e2843 = select(0f, _e837, (_e837 > 0f));
let _e2848 = ((_e837 - _e2775) * _e2745);
let _e2850 = select(0f, _e2848, (_e2848 > 0f));
let _e2852 = (_e2753 + _e2850);
let _e2857 = (-(_e837) * _e2745);
let _e2859 = select(0f, _e2857, (_e2857 > 0f));
let _e2861 = (_e2753 + _e2859);
let _e2868 = (((_e2753 + (select(_e2775, _e2843, (_e2843 < _e2775)) * _e2745)) + (((_e2850 * _e2753) / select(1e-12f, _e2852, (_e2852 > 1e-12f))) - ((_e2859 * _e2753) / select(1e-12f, _e2861, (_e2861 > 1e-12f))))) - 0.5f);
if _e197 {
phi_5389_ = vec3<f32>((_e940 + -1f), (_e941 + -1f), (_e942 + -1f));
} else {
phi_5389_ = vec3<f32>(-1f, -1f, -1f);
}
let _e2874 = phi_5389_;
if _e197 {
phi_5545_ = vec3<f32>((_e1185 + -1f), (_e1186 + -1f), (_e1187 + -1f));
} else {
phi_5545_ = vec3<f32>(-1f, -1f, -1f);
}
let _e2880 = phi_5545_;
let _e2884 = global_2.member.member_7.member_1;
let _e2885 = (_e2884 - _e2655);
let _e2887 = select(_e2733, _e2885, (_e2885 < _e2733));
let _e2889 = select(0f, _e2887, (_e2887 > 0f));
let _e2893 = global_2.member.member_12.member_24;
let _e2897 = ((_e2733 * _e2733) - (_e2889 * _e2889));
let _e2899 = select(0f, _e2897, (_e2897 > 0f));
let _e2908 = global_2.member.member_12.member_8;
let _e2910 = (((_e201 * select(_e2733, sqrt(select(0f, _e2899, (_e2899 > 0f))), (_e2893 > 0f))) * _e2908) * _e2745);
let _e2913 = (((1f + 1f) + 1f) + 1f);
if (_e2913 > 0f) {
let _e2915 = (1.7320508f * _e2910);
if _e202 {
let _e2918 = (0.5f * select(1f, _e2915, (_e2915 > 1f)));
let _e2920 = select(_e2745, _e2918, (_e2918 > _e2745));
phi_5716_ = select(8f, _e2920, (_e2920 < 8f));
} else {
phi_5716_ = 1f;
}
let _e2924 = phi_5716_;
let _e2926 = (_e2835 - _e2773);
let _e2927 = (_e2802 - _e2802);
let _e2930 = bitcast<f32>((bitcast<u32>(_e2926) & 2147483647u));
let _e2933 = bitcast<f32>((bitcast<u32>(_e2927) & 2147483647u));
let _e2935 = select(_e2933, _e2930, (_e2930 > _e2933));
let _e2936 = (_e2868 - _e2868);
let _e2939 = bitcast<f32>((bitcast<u32>(_e2936) & 2147483647u));
let _e2941 = select(_e2939, _e2930, (_e2930 > _e2939));
let _e2945 = ((select(_e2941, _e2935, (_e2935 > _e2941)) / _e2924) - 1e-3f);
let _e2946 = (128f - 1f);
let _e2948 = select(0f, _e2945, (_e2945 > 0f));
let _e2950 = select(_e2946, _e2948, (_e2948 < _e2946));
let _e2957 = select(0i, select(select(i32(_e2950), i32(-2147483648), (_e2950 < -2147483600f)), 2147483647i, (_e2950 > 2147483500f)), (_e2950 == _e2950));
let _e2963 = f32((1i + (_e2957 - select(0i, 1i, (_e2950 < f32(_e2957))))));
let _e2964 = (_e2773 - _e2773);
let _e2965 = (_e2868 - _e2802);
let _e2968 = bitcast<f32>((bitcast<u32>(_e2964) & 2147483647u));
let _e2971 = bitcast<f32>((bitcast<u32>(_e2965) & 2147483647u));
let _e2973 = select(_e2971, _e2968, (_e2968 > _e2971));
let _e2974 = (_e2835 - _e2835);
let _e2977 = bitcast<f32>((bitcast<u32>(_e2974) & 2147483647u));
let _e2979 = select(_e2971, _e2977, (_e2977 > _e2971));
let _e2983 = ((select(_e2979, _e2973, (_e2973 > _e2979)) / _e2924) - 1e-3f);
let _e2985 = select(0f, _e2983, (_e2983 > 0f));
let _e2987 = select(_e2946, _e2985, (_e2985 < _e2946));
let _e2994 = select(0i, select(select(i32(_e2987), i32(-2147483648), (_e2987 < -2147483600f)), 2147483647i, (_e2987 > 2147483500f)), (_e2987 == _e2987));
let _e3000 = f32((1i + (_e2994 - select(0i, 1i, (_e2987 < f32(_e2994))))));
let _e3002 = (select(128f, 24f, _e202) / (_e2963 * _e3000));
let _e3004 = select(_e3002, 1f, (1f < _e3002));
let _e3007 = sqrt(select(0f, _e3004, (_e3004 > 0f)));
let _e3008 = (_e2963 * _e3007);
let _e3010 = select(1f, _e3008, (_e3008 > 1f));
let _e3012 = select(128f, _e3010, (_e3010 < 128f));
let _e3019 = select(0i, select(select(i32(_e3012), i32(-2147483648), (_e3012 < -2147483600f)), 2147483647i, (_e3012 > 2147483500f)), (_e3012 == _e3012));
let _e3023 = (_e3019 - select(0i, 1i, (_e3012 < f32(_e3019))));
let _e3024 = (_e3000 * _e3007);
let _e3026 = select(1f, _e3024, (_e3024 > 1f));
let _e3028 = select(128f, _e3026, (_e3026 < 128f));
let _e3035 = select(0i, select(select(i32(_e3028), i32(-2147483648), (_e3028 < -2147483600f)), 2147483647i, (_e3028 > 2147483500f)), (_e3028 == _e3028));
let _e3039 = (_e3035 - select(0i, 1i, (_e3028 < f32(_e3035))));
let _e3041 = (1f / f32(_e3023));
let _e3043 = (1f / f32(_e3039));
let _e3046 = ((_e3041 * _e3043) * (_e2913 * 0.25f));
phi_5929_ = 0i;
loop {
let _e3048 = phi_5929_;
let _e3049 = (_e3048 < _e3039);
if _e3049 {
let _e3052 = ((f32(_e3048) + 0.5f) * _e3043);
phi_5964_ = 0i;
loop {
let _e3060 = phi_5964_;
let _e3061 = (_e3060 < _e3023);
if _e3061 {
let _e3064 = ((f32(_e3060) + 0.5f) * _e3041);
let _e3071 = ((_e2926 + ((_e2926 - _e2926) * _e3052)) * _e3041);
let _e3072 = ((_e2927 + ((_e2936 - _e2927) * _e3052)) * _e3041);
let _e3073 = ((_e2964 + ((_e2974 - _e2964) * _e3064)) * _e3043);
let _e3074 = ((_e2965 + ((_e2965 - _e2965) * _e3064)) * _e3043);
let _e3080 = bitcast<f32>((bitcast<u32>(((_e3071 * _e3074) - (_e3072 * _e3073))) & 2147483647u));
let _e3083 = bitcast<f32>((bitcast<u32>(_e3071) & 2147483647u));
let _e3086 = bitcast<f32>((bitcast<u32>(_e3074) & 2147483647u));
let _e3089 = bitcast<f32>((bitcast<u32>(_e3073) & 2147483647u));
let _e3090 = (_e3083 + _e3089);
let _e3093 = bitcast<f32>((bitcast<u32>(_e3072) & 2147483647u));
let _e3094 = (_e3086 + _e3093);
let _e3098 = (9.765625e-4f * 9.765625e-4f);
let _e3101 = (_e3080 / select(_e3098, _e3083, (_e3083 > _e3098)));
let _e3106 = (_e3080 / select(_e3098, _e3086, (_e3086 > _e3098)));
if ((_e3089 * _e3086) <= (_e3093 * _e3083)) {
phi_6055_ = vec2<f32>(_e3083, select(_e3094, _e3101, (_e3101 < _e3094)));
} else {
phi_6055_ = vec2<f32>(select(_e3090, _e3106, (_e3106 < _e3090)), _e3086);
}
let _e3112 = phi_6055_;
let _e3116 = (_e2773 + (_e2926 * _e3064));
let _e3119 = (_e3116 + ((_e3116 - _e3116) * _e3052));
let _e3121 = (_e2802 + (_e2927 * _e3064));
let _e3126 = (_e3121 + (((_e2868 + (_e2936 * _e3064)) - _e3121) * _e3052));
let _e3133 = (_e2808.x + ((_e2841.x - _e2808.x) * _e3064));
let _e3140 = ((_e3133 + (((_e2874.x + ((_e2880.x - _e2874.x) * _e3064)) - _e3133) * _e3052)) * _e3046);
let _e3147 = (_e2808.y + ((_e2841.y - _e2808.y) * _e3064));
let _e3154 = ((_e3147 + (((_e2874.y + ((_e2880.y - _e2874.y) * _e3064)) - _e3147) * _e3052)) * _e3046);
let _e3161 = (_e2808.z + ((_e2841.z - _e2808.z) * _e3064));
let _e3168 = ((_e3161 + (((_e2874.z + ((_e2880.z - _e2874.z) * _e3064)) - _e3161) * _e3052)) * _e3046);
if _e202 {
let _e3418 = select(1f, _e3112.x, (_e3112.x > 1f));
let _e3420 = select(8f, _e3418, (_e3418 < 8f));
let _e3422 = select(1f, _e3112.y, (_e3112.y > 1f));
let _e3424 = select(8f, _e3422, (_e3422 < 8f));
let _e3426 = (0.5f * (_e3420 + _e3424));
let _e3430 = (((3f * _e2910) * _e2910) - (_e3426 * _e3426));
let _e3431 = (1f * 1f);
let _e3433 = select(_e3431, _e3430, (_e3430 > _e3431));
let _e3436 = sqrt(select(0f, _e3433, (_e3433 > 0f)));
let _e3438 = (1f / (_e3436 * _e3436));
phi_6184_ = 0i;
loop {
let _e3443 = phi_6184_;
let _e3444 = (_e3443 < 4i);
if _e3444 {
let _e3446 = f32((_e3443 & 1i));
let _e3449 = f32((_e3443 >> bitcast<u32>(1i)));
let _e3454 = ((1f - (2f * _e3446)) * (1f - (2f * _e3449)));
let _e3458 = ((_e3119 + ((_e3446 - 0.5f) * _e3436)) + 0.5f);
let _e3462 = ((_e3126 + ((_e3449 - 0.5f) * _e3436)) + 0.5f);
let _e3463 = (0.5f * _e3420);
let _e3464 = (_e3463 - 0.5f);
let _e3467 = (0.5f * _e3424);
let _e3468 = (_e3467 - 0.5f);
let _e3474 = (select(_e3464, _e3458, (_e3458 > _e3464)) - _e3463);
let _e3475 = (select(_e3468, _e3462, (_e3462 > _e3468)) - _e3467);
let _e3476 = (_e3474 + 0.5f);
let _e3478 = select(0f, _e3476, (_e3476 > 0f));
let _e3480 = select(65536f, _e3478, (_e3478 < 65536f));
let _e3487 = select(0i, select(select(i32(_e3480), i32(-2147483648), (_e3480 < -2147483600f)), 2147483647i, (_e3480 > 2147483500f)), (_e3480 == _e3480));
let _e3492 = (_e3474 + _e3420);
let _e3493 = (_e3492 + 0.5f);
let _e3495 = f32((_e232 - 1i));
let _e3497 = select(-1f, _e3493, (_e3493 > -1f));
let _e3499 = select(_e3495, _e3497, (_e3497 < _e3495));
let _e3506 = select(0i, select(select(i32(_e3499), i32(-2147483648), (_e3499 < -2147483600f)), 2147483647i, (_e3499 > 2147483500f)), (_e3499 == _e3499));
let _e3511 = (_e3475 + _e3424);
let _e3512 = (_e3511 + 0.5f);
let _e3514 = f32((_e239 - 1i));
let _e3516 = select(-1f, _e3512, (_e3512 > -1f));
let _e3518 = select(_e3514, _e3516, (_e3516 < _e3514));
let _e3525 = select(0i, select(select(i32(_e3518), i32(-2147483648), (_e3518 < -2147483600f)), 2147483647i, (_e3518 > 2147483500f)), (_e3518 == _e3518));
let _e3530 = (_e3475 + 0.5f);
let _e3532 = select(0f, _e3530, (_e3530 > 0f));
let _e3534 = select(65536f, _e3532, (_e3532 < 65536f));
let _e3541 = select(0i, select(select(i32(_e3534), i32(-2147483648), (_e3534 < -2147483600f)), 2147483647i, (_e3534 > 2147483500f)), (_e3534 == _e3534));
phi_6341_ = (_e3541 - select(0i, 1i, (_e3534 < f32(_e3541))));
loop {
let _e3547 = phi_6341_;
let _e3548 = (_e3547 <= (_e3525 - select(0i, 1i, (_e3518 < f32(_e3525)))));
if _e3548 {
let _e3549 = f32(_e3547);
let _e3550 = (_e3549 - 0.5f);
let _e3553 = (_e3549 + 0.5f);
let _e3556 = (select(_e3553, _e3511, (_e3511 < _e3553)) - select(_e3550, _e3475, (_e3475 > _e3550)));
phi_6373_ = (_e3487 - select(0i, 1i, (_e3480 < f32(_e3487))));
loop {
let _e3561 = phi_6373_;
let _e3562 = (_e3561 <= (_e3506 - select(0i, 1i, (_e3499 < f32(_e3506)))));
if _e3562 {
let _e3563 = f32(_e3561);
let _e3564 = (_e3563 - 0.5f);
let _e3567 = (_e3563 + 0.5f);
let _e3570 = (select(_e3567, _e3492, (_e3492 < _e3567)) - select(_e3564, _e3474, (_e3474 > _e3564)));
let _e3574 = ((select(0f, _e3570, (_e3570 > 0f)) / _e3420) * (select(0f, _e3556, (_e3556 > 0f)) / _e3424));
if (_e3574 > 0f) {
let _e3578 = (((_e3547 * _e232) + _e3561) * 6i);
let _e3581 = (((((_e3140 * _e3438) * _e3454) * _e3574) * 16777216f) + 0.5f);
let _e3583 = select(-1073741800f, _e3581, (_e3581 > -1073741800f));
let _e3585 = select(1073741800f, _e3583, (_e3583 < 1073741800f));
let _e3592 = select(0i, select(select(i32(_e3585), i32(-2147483648), (_e3585 < -2147483600f)), 2147483647i, (_e3585 > 2147483500f)), (_e3585 == _e3585));
let _e3596 = (_e3592 - select(0i, 1i, (_e3585 < f32(_e3592))));
let _e3597 = bitcast<u32>(_e3596);
let _e3600 = bitcast<u32>((_e3596 >> bitcast<u32>(31i)));
if ((_e3597 | _e3600) == 0u) {
} else {
let _e3603 = bitcast<u32>(_e3578);
if (_e3603 < _e63) {
let _e3607 = atomicAdd((&global_3.member[_e3603]), _e3597);
phi_6454_ = _e3607;
} else {
phi_6454_ = 0u;
}
let _e3609 = phi_6454_;
let _e3613 = (_e3600 + select(0u, 1u, ((_e3609 + _e3597) < _e3597)));
if (_e3613 == 0u) {
} else {
let _e3615 = (_e3603 + 1u);
if (_e3615 < _e63) {
let _e3619 = atomicAdd((&global_3.member[_e3615]), _e3613);
}
}
}
let _e3623 = (((((_e3154 * _e3438) * _e3454) * _e3574) * 16777216f) + 0.5f);
let _e3625 = select(-1073741800f, _e3623, (_e3623 > -1073741800f));
let _e3627 = select(1073741800f, _e3625, (_e3625 < 1073741800f));
let _e3634 = select(0i, select(select(i32(_e3627), i32(-2147483648), (_e3627 < -2147483600f)), 2147483647i, (_e3627 > 2147483500f)), (_e3627 == _e3627));
let _e3638 = (_e3634 - select(0i, 1i, (_e3627 < f32(_e3634))));
let _e3639 = bitcast<u32>(_e3638);
let _e3642 = bitcast<u32>((_e3638 >> bitcast<u32>(31i)));
if ((_e3639 | _e3642) == 0u) {
} else {
let _e3645 = bitcast<u32>((_e3578 + 2i));
if (_e3645 < _e63) {
let _e3649 = atomicAdd((&global_3.member[_e3645]), _e3639);
phi_6512_ = _e3649;
} else {
phi_6512_ = 0u;
}
let _e3651 = phi_6512_;
let _e3655 = (_e3642 + select(0u, 1u, ((_e3651 + _e3639) < _e3639)));
if (_e3655 == 0u) {
} else {
let _e3657 = (_e3645 + 1u);
if (_e3657 < _e63) {
let _e3661 = atomicAdd((&global_3.member[_e3657]), _e3655);
}
}
}
let _e3665 = (((((_e3168 * _e3438) * _e3454) * _e3574) * 16777216f) + 0.5f);
let _e3667 = select(-1073741800f, _e3665, (_e3665 > -1073741800f));
let _e3669 = select(1073741800f, _e3667, (_e3667 < 1073741800f));
let _e3676 = select(0i, select(select(i32(_e3669), i32(-2147483648), (_e3669 < -2147483600f)), 2147483647i, (_e3669 > 2147483500f)), (_e3669 == _e3669));
let _e3680 = (_e3676 - select(0i, 1i, (_e3669 < f32(_e3676))));
let _e3681 = bitcast<u32>(_e3680);
let _e3684 = bitcast<u32>((_e3680 >> bitcast<u32>(31i)));
if ((_e3681 | _e3684) == 0u) {
} else {
let _e3687 = bitcast<u32>((_e3578 + 4i));
if (_e3687 < _e63) {
let _e3691 = atomicAdd((&global_3.member[_e3687]), _e3681);
phi_6570_ = _e3691;
} else {
phi_6570_ = 0u;
}
let _e3693 = phi_6570_;
let _e3697 = (_e3684 + select(0u, 1u, ((_e3693 + _e3681) < _e3681)));
if (_e3697 == 0u) {
} else {
let _e3699 = (_e3687 + 1u);
if (_e3699 < _e63) {
let _e3703 = atomicAdd((&global_3.member[_e3699]), _e3697);
}
}
}
}
phi_6374_ = (_e3561 + 1i);
} else {
phi_6374_ = i32();
}
let _e3706 = phi_6374_;
continue;
continuing {
phi_6373_ = _e3706;
break if !(_e3562);
}
}
phi_6342_ = (_e3547 + 1i);
} else {
phi_6342_ = i32();
}
let _e3710 = phi_6342_;
continue;
continuing {
phi_6341_ = _e3710;
break if !(_e3548);
}
}
phi_6185_ = (_e3443 + 1i);
} else {
phi_6185_ = i32();
}
let _e3714 = phi_6185_;
continue;
continuing {
phi_6184_ = _e3714;
break if !(_e3444);
}
}
} else {
let _e3170 = select(9.765625e-4f, _e3112.x, (_e3112.x > 9.765625e-4f));
let _e3172 = select(5f, _e3170, (_e3170 < 5f));
let _e3174 = select(9.765625e-4f, _e3112.y, (_e3112.y > 9.765625e-4f));
let _e3176 = select(5f, _e3174, (_e3174 < 5f));
let _e3178 = (_e3119 - (0.5f * _e3172));
let _e3180 = (_e3126 - (0.5f * _e3176));
let _e3181 = (_e3178 + 0.5f);
let _e3183 = select(0f, _e3181, (_e3181 > 0f));
let _e3185 = select(65536f, _e3183, (_e3183 < 65536f));
let _e3192 = select(0i, select(select(i32(_e3185), i32(-2147483648), (_e3185 < -2147483600f)), 2147483647i, (_e3185 > 2147483500f)), (_e3185 == _e3185));
let _e3197 = (_e3178 + _e3172);
let _e3198 = (_e3197 + 0.5f);
let _e3200 = f32((_e232 - 1i));
let _e3202 = select(-1f, _e3198, (_e3198 > -1f));
let _e3204 = select(_e3200, _e3202, (_e3202 < _e3200));
let _e3211 = select(0i, select(select(i32(_e3204), i32(-2147483648), (_e3204 < -2147483600f)), 2147483647i, (_e3204 > 2147483500f)), (_e3204 == _e3204));
let _e3216 = (_e3180 + _e3176);
let _e3217 = (_e3216 + 0.5f);
let _e3219 = f32((_e239 - 1i));
let _e3221 = select(-1f, _e3217, (_e3217 > -1f));
let _e3223 = select(_e3219, _e3221, (_e3221 < _e3219));
let _e3230 = select(0i, select(select(i32(_e3223), i32(-2147483648), (_e3223 < -2147483600f)), 2147483647i, (_e3223 > 2147483500f)), (_e3223 == _e3223));
let _e3235 = (_e3180 + 0.5f);
let _e3237 = select(0f, _e3235, (_e3235 > 0f));
let _e3239 = select(65536f, _e3237, (_e3237 < 65536f));
let _e3246 = select(0i, select(select(i32(_e3239), i32(-2147483648), (_e3239 < -2147483600f)), 2147483647i, (_e3239 > 2147483500f)), (_e3239 == _e3239));
phi_6724_ = (_e3246 - select(0i, 1i, (_e3239 < f32(_e3246))));
loop {
let _e3252 = phi_6724_;
let _e3253 = (_e3252 <= (_e3230 - select(0i, 1i, (_e3223 < f32(_e3230)))));
if _e3253 {
let _e3254 = f32(_e3252);
let _e3255 = (_e3254 - 0.5f);
let _e3258 = (_e3254 + 0.5f);
let _e3261 = (select(_e3258, _e3216, (_e3216 < _e3258)) - select(_e3255, _e3180, (_e3180 > _e3255)));
phi_6756_ = (_e3192 - select(0i, 1i, (_e3185 < f32(_e3192))));
loop {
let _e3266 = phi_6756_;
let _e3267 = (_e3266 <= (_e3211 - select(0i, 1i, (_e3204 < f32(_e3211)))));
if _e3267 {
let _e3268 = f32(_e3266);
let _e3269 = (_e3268 - 0.5f);
let _e3272 = (_e3268 + 0.5f);
let _e3275 = (select(_e3272, _e3197, (_e3197 < _e3272)) - select(_e3269, _e3178, (_e3178 > _e3269)));
let _e3279 = ((select(0f, _e3275, (_e3275 > 0f)) / _e3172) * (select(0f, _e3261, (_e3261 > 0f)) / _e3176));
if (_e3279 > 0f) {
let _e3283 = (((_e3252 * _e232) + _e3266) * 6i);
let _e3286 = (((_e3140 * _e3279) * 16777216f) + 0.5f);
let _e3288 = select(-1073741800f, _e3286, (_e3286 > -1073741800f));
let _e3290 = select(1073741800f, _e3288, (_e3288 < 1073741800f));
let _e3297 = select(0i, select(select(i32(_e3290), i32(-2147483648), (_e3290 < -2147483600f)), 2147483647i, (_e3290 > 2147483500f)), (_e3290 == _e3290));
let _e3301 = (_e3297 - select(0i, 1i, (_e3290 < f32(_e3297))));
let _e3302 = bitcast<u32>(_e3301);
let _e3305 = bitcast<u32>((_e3301 >> bitcast<u32>(31i)));
if ((_e3302 | _e3305) == 0u) {
} else {
let _e3308 = bitcast<u32>(_e3283);
if (_e3308 < _e63) {
let _e3312 = atomicAdd((&global_3.member[_e3308]), _e3302);
phi_6837_ = _e3312;
} else {
phi_6837_ = 0u;
}
let _e3314 = phi_6837_;
let _e3318 = (_e3305 + select(0u, 1u, ((_e3314 + _e3302) < _e3302)));
if (_e3318 == 0u) {
} else {
let _e3320 = (_e3308 + 1u);
if (_e3320 < _e63) {
let _e3324 = atomicAdd((&global_3.member[_e3320]), _e3318);
}
}
}
let _e3328 = (((_e3154 * _e3279) * 16777216f) + 0.5f);
let _e3330 = select(-1073741800f, _e3328, (_e3328 > -1073741800f));
let _e3332 = select(1073741800f, _e3330, (_e3330 < 1073741800f));
let _e3339 = select(0i, select(select(i32(_e3332), i32(-2147483648), (_e3332 < -2147483600f)), 2147483647i, (_e3332 > 2147483500f)), (_e3332 == _e3332));
let _e3343 = (_e3339 - select(0i, 1i, (_e3332 < f32(_e3339))));
let _e3344 = bitcast<u32>(_e3343);
let _e3347 = bitcast<u32>((_e3343 >> bitcast<u32>(31i)));
if ((_e3344 | _e3347) == 0u) {
} else {
let _e3350 = bitcast<u32>((_e3283 + 2i));
if (_e3350 < _e63) {
let _e3354 = atomicAdd((&global_3.member[_e3350]), _e3344);
phi_6895_ = _e3354;
} else {
phi_6895_ = 0u;
}
let _e3356 = phi_6895_;
let _e3360 = (_e3347 + select(0u, 1u, ((_e3356 + _e3344) < _e3344)));
if (_e3360 == 0u) {
} else {
let _e3362 = (_e3350 + 1u);
if (_e3362 < _e63) {
let _e3366 = atomicAdd((&global_3.member[_e3362]), _e3360);
}
}
}
let _e3370 = (((_e3168 * _e3279) * 16777216f) + 0.5f);
let _e3372 = select(-1073741800f, _e3370, (_e3370 > -1073741800f));
let _e3374 = select(1073741800f, _e3372, (_e3372 < 1073741800f));
let _e3381 = select(0i, select(select(i32(_e3374), i32(-2147483648), (_e3374 < -2147483600f)), 2147483647i, (_e3374 > 2147483500f)), (_e3374 == _e3374));
let _e3385 = (_e3381 - select(0i, 1i, (_e3374 < f32(_e3381))));
let _e3386 = bitcast<u32>(_e3385);
let _e3389 = bitcast<u32>((_e3385 >> bitcast<u32>(31i)));
if ((_e3386 | _e3389) == 0u) {
} else {
let _e3392 = bitcast<u32>((_e3283 + 4i));
if (_e3392 < _e63) {
let _e3396 = atomicAdd((&global_3.member[_e3392]), _e3386);
phi_6953_ = _e3396;
} else {
phi_6953_ = 0u;
}
let _e3398 = phi_6953_;
let _e3402 = (_e3389 + select(0u, 1u, ((_e3398 + _e3386) < _e3386)));
if (_e3402 == 0u) {
} else {
let _e3404 = (_e3392 + 1u);
if (_e3404 < _e63) {
let _e3408 = atomicAdd((&global_3.member[_e3404]), _e3402);
}
}
}
}
phi_6757_ = (_e3266 + 1i);
} else {
phi_6757_ = i32();
}
let _e3411 = phi_6757_;
continue;
continuing {
phi_6756_ = _e3411;
break if !(_e3267);
}
}
phi_6725_ = (_e3252 + 1i);
} else {
phi_6725_ = i32();
}
let _e3415 = phi_6725_;
continue;
continuing {
phi_6724_ = _e3415;
break if !(_e3253);
}
}
}
phi_5965_ = (_e3060 + 1i);
} else {
phi_5965_ = i32();
}
let _e3718 = phi_5965_;
continue;
continuing {
phi_5964_ = _e3718;
break if !(_e3061);
}
}
phi_5930_ = (_e3048 + 1i);
} else {
phi_5930_ = i32();
}
let _e3722 = phi_5930_;
continue;
continuing {
phi_5929_ = _e3722;
break if !(_e3049);
}
}
}
}
}
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
